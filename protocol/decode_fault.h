#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace aucast::protocol {

/// Why bytes are not the protocol. PROTOCOL.md lists the names.
enum class DecodeFault : std::uint8_t {
  IllegalByte,    ///< a byte that the grammar does not allow; found before any closing brace
  NumberTooBig,   ///< an AU above 99, a percent above 100, a time beyond the limit
  PacketTooLong,  ///< no closing brace within the limit
  TooManyBlanks,  ///< more blanks in a row than the limit
  UnknownPacket,  ///< {-3} or another number that is no packet, or an unknown word
  BadField,       ///< a field of a hello, an error's code or a stream's name that cannot be read
  UnknownCode,    ///< from a client: a number that is no control code
};

[[nodiscard]] std::string_view name(DecodeFault fault);

/// What is wrong with a byte.
struct ByteFault {
  DecodeFault fault = DecodeFault::IllegalByte;
  std::string reason;    ///< a sentence; the byte is escaped
  std::size_t back = 0;  ///< BadField: the wrong byte is this many bytes before the last one read
};

/// A fault IllegalByte with the reason "expected <expected>, found '<byte>'".
[[nodiscard]] ByteFault unexpected(const std::string& expected, char byte);

/// A fault with its position in the connection's bytes, counted from 0.
struct DecodeError {
  DecodeFault fault = DecodeFault::IllegalByte;
  std::uint64_t position = 0;
  std::string reason;  ///< a sentence; bytes from the peer are escaped
  friend bool operator==(const DecodeError&, const DecodeError&) = default;
};

}  // namespace aucast::protocol
