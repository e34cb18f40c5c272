#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "protocol/keyframe_parser.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// Why a hello, error or streams packet is wrong although all its bytes are legal.
struct FieldFault {
  std::size_t position = 0;  ///< in the packet, whose '{' is at 0
  std::string reason;        ///< a sentence; text from the peer is escaped
};

/// Collects the inside of a packet that begins with a word, byte by byte. The word is checked as it
/// comes. A space or, if the word has one letter, an '@' must follow it; the rest must be printable
/// ASCII without braces. The owner limits the length.
class WordPacket {
 public:
  /// `words`: those that the sender may use. They must outlive the object.
  explicit WordPacket(std::span<const std::string_view> words) : words_(words) {}

  [[nodiscard]] std::optional<ByteFault> accept(char byte);
  /// Call it at the closing brace. Returns a fault when the word is incomplete.
  [[nodiscard]] std::optional<ByteFault> finish() const;

  [[nodiscard]] std::string_view word() const;
  /// The packet's inside, from the word on.
  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  std::span<const std::string_view> words_;
  std::string text_;
  std::size_t word_bytes_ = 0;  ///< 0 while the word is still coming
};

/// Whether the text can be a field's value, after the '=': printable ASCII without spaces and
/// braces.
[[nodiscard]] bool is_field_value(std::string_view text);

/// Each reads the text() of a finished WordPacket that has the function's own word (hello, error,
/// streams). An unsupported version is no fault here, but then no other field is read, since that
/// version may give it another meaning.
[[nodiscard]] std::variant<HelloAsked, FieldFault> parse_hello_asked(std::string_view text);
[[nodiscard]] std::variant<HelloGranted, FieldFault> parse_hello_granted(std::string_view text);
[[nodiscard]] std::variant<ErrorReply, FieldFault> parse_error_reply(std::string_view text);
[[nodiscard]] std::variant<StreamList, FieldFault> parse_stream_list(std::string_view text);
[[nodiscard]] std::variant<StreamsAsked, FieldFault> parse_streams_asked(std::string_view text);

}  // namespace aucast::protocol
