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

/// A hello, error or streams packet whose bytes are legal and whose meaning is not.
struct FieldFault {
  std::size_t position = 0;  ///< in the packet, its '{' counted as 0
  std::string reason;        ///< a sentence, peer text escaped
};

/// Collects the inside of a packet that begins with a word, byte by byte: the word is checked as it
/// comes, what follows it, after a space or (words of one letter) an '@', must be printable ASCII
/// without braces. The length is the owner's business.
class WordPacket {
 public:
  /// `words`: those that this side may send. They must outlive the object.
  explicit WordPacket(std::span<const std::string_view> words) : words_(words) {}

  [[nodiscard]] std::optional<ByteFault> accept(char byte);
  /// At the closing brace: a fault when the word is not complete.
  [[nodiscard]] std::optional<ByteFault> finish() const;

  [[nodiscard]] std::string_view word() const;
  /// The packet's inside, from the word on.
  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  std::span<const std::string_view> words_;
  std::string text_;
  std::size_t word_bytes_ = 0;  ///< 0 while the word is still coming
};

/// True when the text can stand after a field's '=': printable ASCII without spaces and braces.
[[nodiscard]] bool is_field_value(std::string_view text);

/// Each reads the text() of a finished WordPacket of its word. An unsupported version is no fault
/// here: the fields after it may mean something else and are then left alone.
[[nodiscard]] std::variant<HelloAsked, FieldFault> parse_hello_asked(std::string_view text);
[[nodiscard]] std::variant<HelloGranted, FieldFault> parse_hello_granted(std::string_view text);
[[nodiscard]] std::variant<ErrorReply, FieldFault> parse_error_reply(std::string_view text);
[[nodiscard]] std::variant<StreamList, FieldFault> parse_stream_list(std::string_view text);
[[nodiscard]] std::variant<StreamsAsked, FieldFault> parse_streams_asked(std::string_view text);

}  // namespace aucast::protocol
