#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "protocol/codec.h"
#include "protocol/decode_fault.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// Whether the byte is a space, CR or LF.
[[nodiscard]] constexpr bool is_blank(char byte) {
  return byte == ' ' || byte == '\r' || byte == '\n';
}

[[nodiscard]] constexpr bool is_digit(char byte) {
  return byte >= '0' && byte <= '9';
}

/// Reads the inside of a keyframe byte by byte, so that a wrong byte is refused at its own place
/// and not at the closing brace. Used for the wire, stream files and command lines. Grammar:
/// PROTOCOL.md, rules `full` and `changes`. After a fault the parser must not be used again.
class KeyframeParser {
 public:
  explicit KeyframeParser(TermSyntax syntax) : syntax_(syntax) {}

  /// Takes one byte. Returns a fault if it is not allowed here.
  [[nodiscard]] std::optional<ByteFault> accept(char byte);
  /// Ends the keyframe. Returns a fault if something is missing. `end`, for the message, is the
  /// byte that ended it; 0: the end of the text.
  [[nodiscard]] std::optional<ByteFault> finish(char end);
  /// The keyframe that was read. Call it once, after finish() found no fault.
  [[nodiscard]] Keyframe take() { return std::move(keyframe_); }

 private:
  enum class State : std::uint8_t {
    Begin,
    TermOrTiming,  ///< after '~'
    Term,          ///< after a separator
    AuNumber,      ///< after a side, or within the number
    AfterAu,
    Percent,
    AfterIntensity,
    Time,
    AfterTime,
    Place,
    AfterPlace,
  };

  [[nodiscard]] std::optional<ByteFault> add_digit(char byte);
  void end_number();
  [[nodiscard]] bool take_mark(char byte);
  [[nodiscard]] bool begin_term(char byte);
  [[nodiscard]] bool join_term(char byte);
  [[nodiscard]] bool is_blank_here(char byte) const;
  [[nodiscard]] std::string expected(char byte) const;

  TermSyntax syntax_;
  State state_ = State::Begin;
  Side side_ = Side::Both;
  std::uint64_t number_ = 0;  ///< digits read so far; meaningful when digits_ > 0
  int digits_ = 0;
  Keyframe keyframe_;
};

}  // namespace aucast::protocol
