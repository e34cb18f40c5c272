#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace aucast::protocol {

/// Why a byte stream stopped being the protocol. Names are in PROTOCOL.md.
enum class DecodeFault : std::uint8_t {
  IllegalByte,    ///< a byte that the grammar does not allow; found before any closing brace
  NumberTooBig,   ///< an AU above 99, a percent above 100, a time beyond the limit
  PacketTooLong,  ///< no closing brace within the limit
  TooManyBlanks,  ///< more blanks in a row than the limit
  UnknownPacket,  ///< {-3} and the like, or an unknown word
  BadField,       ///< a field of a hello, an error's code or a stream's name that cannot be read
  UnknownCode,    ///< from a client: not a control code
};

[[nodiscard]] std::string_view name(DecodeFault fault);

/// What is wrong with a byte at its place.
struct ByteFault {
  DecodeFault fault = DecodeFault::IllegalByte;
  std::string reason;    ///< a sentence, the byte escaped
  std::size_t back = 0;  ///< how many bytes before the last one read the fault lies (bad fields)
};

/// IllegalByte: "expected <what>, found '<byte>'".
[[nodiscard]] ByteFault unexpected(const std::string& expected, char byte);

/// A fault with its position in the connection's bytes, counted from 0.
struct DecodeError {
  DecodeFault fault = DecodeFault::IllegalByte;
  std::uint64_t position = 0;
  std::string reason;  ///< a sentence, peer bytes escaped
  friend bool operator==(const DecodeError&, const DecodeError&) = default;
};

}  // namespace aucast::protocol
