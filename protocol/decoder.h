#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "protocol/decode_fault.h"
#include "protocol/keyframe_parser.h"
#include "protocol/packet.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {

/// Cuts a byte stream into packets, one at a time. Bytes may come in any portions. Does no I/O.
/// After the first error nothing more is read and error() stays the same.
template <typename Packet>
class PacketDecoder {
 public:
  /// Reads `bytes` up to the end of the first packet and returns the packet; `bytes` is then only
  /// what comes after it. Returns nullopt if all bytes were read and the packet is not complete
  /// yet, or if there is an error().
  [[nodiscard]] std::optional<Packet> next(std::string_view& bytes);
  [[nodiscard]] const std::optional<DecodeError>& error() const { return error_; }
  /// Whether a packet has begun and is not complete.
  [[nodiscard]] bool mid_packet() const { return !error_ && packet_bytes_ > 0; }
  /// Size in bytes of the last packet from next() as it was received: with its braces and the
  /// blanks inside.
  [[nodiscard]] std::size_t taken_bytes() const { return taken_bytes_; }

 protected:
  explicit PacketDecoder(WordPacket word) : word_(std::move(word)) {}
  ~PacketDecoder() = default;
  PacketDecoder(PacketDecoder&&) noexcept = default;
  PacketDecoder& operator=(PacketDecoder&&) noexcept = default;

  [[nodiscard]] virtual std::optional<ByteFault> accept(char byte) = 0;

  /// Counts a blank between two packets. Returns a fault if too many have come in a row.
  [[nodiscard]] std::optional<ByteFault> blank();
  /// Counts one more byte of the packet being read. Returns a fault if the packet has more than
  /// `max` bytes now.
  [[nodiscard]] std::optional<ByteFault> count(std::size_t max);
  void deliver(Packet packet);
  template <typename T>
  [[nodiscard]] std::optional<ByteFault> deliver_parsed(std::variant<T, FieldFault> parsed);

  std::size_t packet_bytes_ = 0;  ///< of the packet being read; 0: none
  WordPacket word_;

 private:
  std::size_t blanks_ = 0;  ///< blanks in a row between packets
  std::size_t taken_bytes_ = 0;
  std::uint64_t bytes_seen_ = 0;
  std::optional<Packet> packet_;
  std::optional<DecodeError> error_;
};

/// Decodes what a server sends. Invariant: keeps at most one packet, of kPacketBytesMax bytes as it
/// came.
class ServerPacketDecoder final : public PacketDecoder<ServerPacket> {
 public:
  ServerPacketDecoder();

 private:
  enum class Inside : std::uint8_t {
    Opened,   ///< after '{'
    Minus,    ///< after "{-"
    EndRead,  ///< after "{-2"
    Keyframe,
    Word,
  };

  [[nodiscard]] std::optional<ByteFault> accept(char byte) override;
  [[nodiscard]] std::optional<ByteFault> open(char byte);
  [[nodiscard]] std::optional<ByteFault> end_mark(char byte);
  [[nodiscard]] std::optional<ByteFault> close();
  [[nodiscard]] std::optional<ByteFault> close_word();
  [[nodiscard]] std::size_t bytes_max() const;

  Inside inside_ = Inside::Opened;
  KeyframeParser keyframe_{TermSyntax::Wire};
};

/// Decodes what a client sends: perhaps a hello or {streams}, then control codes, each of which
/// ends with its digit. Blanks before, between and after them are skipped.
/// Invariant: keeps at most kHelloBytesMax bytes.
class ClientPacketDecoder final : public PacketDecoder<ClientPacket> {
 public:
  ClientPacketDecoder();

 private:
  [[nodiscard]] std::optional<ByteFault> accept(char byte) override;
  [[nodiscard]] std::optional<ByteFault> after_minus(char byte);
  [[nodiscard]] std::optional<ByteFault> close_word();

  bool word_allowed_ = true;  ///< only blanks have come so far
  bool minus_ = false;        ///< the packet being read began with '-'
};

}  // namespace aucast::protocol
