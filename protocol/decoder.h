#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/packet.h"

namespace aucast::protocol {

/// Why a byte stream stopped being the protocol. Names are in PROTOCOL.md.
enum class DecodeFault : std::uint8_t {
  IllegalByte,    ///< a byte that cannot stand there; found before any closing brace
  NumberTooBig,   ///< an AU above 99, a percent above 100, a time beyond the limit
  PacketTooLong,  ///< no closing brace within the limit
  TooManyBlanks,  ///< blanks between packets beyond the limit
  UnknownPacket,  ///< {-3} and the like, or a word that is none of ours
  BadField,       ///< a hello or error whose field cannot be read
  UnknownCode,    ///< from a client: something that is no control code
};

[[nodiscard]] std::string_view name(DecodeFault fault);

/// A fault with its place: `position` counts the bytes of the connection from 0.
struct DecodeError {
  DecodeFault fault = DecodeFault::IllegalByte;
  std::uint64_t position = 0;
  std::string reason;  ///< a sentence, peer bytes escaped
  friend bool operator==(const DecodeError&, const DecodeError&) = default;
};

/// Cuts what a server sends into packets. Bytes may come in any portions. Does no I/O.
/// Invariant: at most kPacketBytesMax bytes are held back. After the first error every feed() is
/// ignored and error() stays the same (sticky); packets complete before it can still be taken.
class ServerPacketDecoder {
 public:
  ServerPacketDecoder();
  ~ServerPacketDecoder();
  ServerPacketDecoder(ServerPacketDecoder&&) noexcept;
  ServerPacketDecoder& operator=(ServerPacketDecoder&&) noexcept;

  void feed(std::string_view bytes);
  /// The next complete packet, in the order of arrival.
  [[nodiscard]] std::optional<ServerPacket> next();
  [[nodiscard]] const std::optional<DecodeError>& error() const;
  /// True when a packet was begun and not finished.
  [[nodiscard]] bool mid_packet() const;
  [[nodiscard]] std::uint64_t bytes_seen() const;
  /// Size of the packet that next() gave last, as it came: with its braces and blanks inside.
  [[nodiscard]] std::size_t taken_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same for what a client sends: control codes, each complete at its digit, and a hello or
/// {streams} before the first of them. Blanks before, between and after them are skipped.
/// Invariant: at most kHelloBytesMax bytes are held back.
class ClientPacketDecoder {
 public:
  ClientPacketDecoder();
  ~ClientPacketDecoder();
  ClientPacketDecoder(ClientPacketDecoder&&) noexcept;
  ClientPacketDecoder& operator=(ClientPacketDecoder&&) noexcept;

  void feed(std::string_view bytes);
  [[nodiscard]] std::optional<ClientPacket> next();
  [[nodiscard]] const std::optional<DecodeError>& error() const;
  [[nodiscard]] bool mid_packet() const;
  [[nodiscard]] std::uint64_t bytes_seen() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::protocol
