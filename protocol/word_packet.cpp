#include "protocol/word_packet.h"

#include <algorithm>
#include <vector>

#include "common/text.h"
#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

bool is_printable(char byte) {
  return byte >= 0x20 && byte < 0x7f;
}

/// One blank-separated piece of a packet's inside.
struct Piece {
  std::string_view text;
  std::size_t position = 0;  ///< in the packet, its '{' counted as 0
};

/// The pieces after the word; more than one space between two of them is accepted.
std::vector<Piece> pieces_after_word(std::string_view text) {
  std::vector<Piece> pieces;
  std::size_t begin = std::min(text.find(' '), text.size());
  while (begin < text.size()) {
    if (text[begin] == ' ') {
      ++begin;
      continue;
    }
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    pieces.push_back({text.substr(begin, end - begin), begin + 1});
    begin = end;
  }
  return pieces;
}

/// The fields of a hello, and the first fault met while reading them.
class Fields {
 public:
  explicit Fields(std::string_view text) {
    for (const Piece& piece : pieces_after_word(text)) {
      const std::size_t equals = piece.text.find('=');
      if (equals == 0 || equals == std::string_view::npos) {
        refuse(piece.position, "expected key=value, found '" + escaped(piece.text) + "'");
        return;
      }
      fields_.push_back({piece.text.substr(0, equals), piece.text.substr(equals + 1),
                         piece.position + equals + 1});
    }
  }

  /// A whole number of `min` to `max`; nothing when the key is absent or its value is refused. A
  /// repeated key: the last wins.
  std::optional<std::uint64_t> number(std::string_view key, std::uint64_t max,
                                      std::uint64_t min = 0) {
    const Field* field = find(key);
    if (field == nullptr) return std::nullopt;
    std::uint64_t value = 0;
    bool fits = !field->value.empty() && field->value.size() <= kDigitsMax;
    for (const char byte : field->value) {
      fits = fits && is_digit(byte);
      if (fits) value = value * 10 + static_cast<std::uint64_t>(byte - '0');
    }
    if (fits && value >= min && value <= max) return value;
    refuse(field->position, std::string(key) + " is a number of " + std::to_string(min) + "-" +
                                std::to_string(max) + ", found '" + escaped(field->value) + "'");
    return std::nullopt;
  }

  std::optional<bool> flag(std::string_view key) {
    const auto value = number(key, 1);
    if (!value) return std::nullopt;
    return *value == 1;
  }

  std::optional<std::string> stream_name(std::string_view key) {
    const Field* field = find(key);
    if (field == nullptr) return std::nullopt;
    if (is_stream_name(field->value)) return std::string(field->value);
    refuse(field->position, std::string(key) + " is a name of 1-64 letters, digits, '.', '_' or " +
                                "'-', found '" + escaped(field->value) + "'");
    return std::nullopt;
  }

  std::optional<std::string> text(std::string_view key) const {
    const Field* field = find(key);
    if (field == nullptr) return std::nullopt;
    return std::string(field->value);
  }

  [[nodiscard]] const std::optional<FieldFault>& fault() const { return fault_; }

 private:
  struct Field {
    std::string_view key;
    std::string_view value;
    std::size_t position = 0;  ///< of the value
  };

  /// More digits than any of our numbers has; 18 digits cannot overflow.
  static constexpr std::size_t kDigitsMax = 18;

  [[nodiscard]] const Field* find(std::string_view key) const {
    const auto found = std::find_if(fields_.rbegin(), fields_.rend(),
                                    [key](const Field& field) { return field.key == key; });
    return found == fields_.rend() ? nullptr : &*found;
  }

  void refuse(std::size_t position, std::string reason) {
    if (!fault_) fault_ = FieldFault{position, std::move(reason)};
  }

  std::vector<Field> fields_;
  std::optional<FieldFault> fault_;
};

/// Windows above kWindowMax may be asked for (less is granted); this only bounds the digits.
constexpr std::uint64_t kWindowAskedMax = 999'999;
constexpr std::uint64_t kVersionAskedMax = 999'999;

/// The version, which must be understood before any other field means something.
int read_version(Fields& fields) {
  return static_cast<int>(fields.number("v", kVersionAskedMax).value_or(kProtocolVersion));
}

}  // namespace

std::optional<ByteFault> WordPacket::accept(char byte) {
  if (word_bytes_ == 0) {
    const bool complete =
        std::find(words_.begin(), words_.end(), std::string_view(text_)) != words_.end();
    if (complete && byte == ' ') {
      word_bytes_ = text_.size();
    } else {
      const std::string longer = text_ + byte;
      const bool known = std::any_of(words_.begin(), words_.end(), [&](std::string_view word) {
        return word.starts_with(longer);
      });
      if (!known) {
        return ByteFault{DecodeFault::UnknownPacket,
                         "the word beginning '" + escaped(longer) + "' is none of the protocol's"};
      }
    }
  } else if (!is_printable(byte) || byte == '{') {
    return unexpected("printable text or '}'", byte);
  }
  text_ += byte;
  return std::nullopt;
}

std::optional<ByteFault> WordPacket::finish() const {
  if (std::find(words_.begin(), words_.end(), word()) != words_.end()) return std::nullopt;
  return ByteFault{DecodeFault::UnknownPacket,
                   "the word '" + escaped(text_) + "' is none of the protocol's"};
}

std::string_view WordPacket::word() const {
  const std::string_view text = text_;
  return word_bytes_ == 0 ? text : text.substr(0, word_bytes_);
}

bool is_field_value(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char byte) {
    return is_printable(byte) && byte != ' ' && byte != '{' && byte != '}';
  });
}

std::variant<HelloAsked, FieldFault> parse_hello_asked(std::string_view text) {
  Fields fields(text);
  HelloAsked hello;
  hello.version = read_version(fields);
  if (fields.fault()) return *fields.fault();
  if (hello.version != kProtocolVersion) return hello;
  hello.window = static_cast<int>(fields.number("window", kWindowAskedMax).value_or(1));
  hello.stream = fields.stream_name("stream").value_or("");
  hello.token = fields.text("token").value_or("");
  hello.delta = fields.flag("delta").value_or(false);
  hello.from_ms = fields.number("from", kPlaceMsMax).value_or(0);
  if (fields.fault()) return *fields.fault();
  return hello;
}

std::variant<HelloGranted, FieldFault> parse_hello_granted(std::string_view text) {
  Fields fields(text);
  HelloGranted hello;
  hello.version = read_version(fields);
  if (fields.fault()) return *fields.fault();
  if (hello.version != kProtocolVersion) return hello;
  hello.window = static_cast<int>(fields.number("window", kWindowMax).value_or(1));
  hello.delta = fields.flag("delta").value_or(false);
  hello.stream = fields.stream_name("stream").value_or("");
  hello.live = fields.flag("live").value_or(false);
  hello.duration_ms = fields.number("duration", kPlaceMsMax);
  hello.keyframe_ms =
      static_cast<std::uint32_t>(fields.number("keyframe", kDurationMsMax, 1).value_or(250));
  hello.from_ms = fields.number("from", kPlaceMsMax).value_or(0);
  if (fields.fault()) return *fields.fault();
  return hello;
}

std::variant<ErrorReply, FieldFault> parse_error_reply(std::string_view text) {
  const std::vector<Piece> pieces = pieces_after_word(text);
  const bool is_code =
      !pieces.empty() && pieces.front().text.size() == 3 && pieces.front().text.front() != '0' &&
      std::all_of(pieces.front().text.begin(), pieces.front().text.end(), is_digit);
  if (!is_code) {
    const Piece found = pieces.empty() ? Piece{"", text.size() + 1} : pieces.front();
    return FieldFault{found.position,
                      "an error has a code of 100-999, found '" + escaped(found.text) + "'"};
  }
  ErrorReply error{0, {}};
  for (const char byte : pieces.front().text) error.code = error.code * 10 + (byte - '0');
  // The text is everything after the code and one space, as it stands.
  const std::size_t end_of_code = pieces.front().position - 1 + 3;
  if (end_of_code < text.size()) error.text = text.substr(end_of_code + 1);
  return error;
}

std::variant<StreamList, FieldFault> parse_stream_list(std::string_view text) {
  StreamList list;
  for (const Piece& piece : pieces_after_word(text)) {
    if (!is_stream_name(piece.text)) {
      return FieldFault{piece.position, "'" + escaped(piece.text) + "' is no stream's name"};
    }
    list.names.emplace_back(piece.text);
  }
  return list;
}

std::variant<StreamsAsked, FieldFault> parse_streams_asked(std::string_view text) {
  const Fields fields(text);
  if (fields.fault()) return *fields.fault();
  return StreamsAsked{fields.text("token").value_or("")};
}

}  // namespace aucast::protocol
