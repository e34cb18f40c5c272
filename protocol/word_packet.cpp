#include "protocol/word_packet.h"

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <vector>

#include "common/number_of.h"
#include "common/text.h"
#include "protocol/base64.h"
#include "protocol/caption.h"
#include "protocol/codec.h"
#include "protocol/limits.h"
#include "protocol/server_chain.h"

namespace aucast::protocol {
namespace {

bool is_printable(char byte) {
  return byte >= 0x20 && byte < 0x7f;
}

/// One blank-separated piece of a packet's inside.
struct Piece {
  std::string_view text;
  std::size_t position = 0;  ///< in the packet, whose '{' is at 0
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

enum class Kind : std::uint8_t { Number, Name, Token, Text, ServerId, Servers };

/// A key of a hello or of a stream in a list: where its value goes and what it may be. The default
/// is what the member is initialized with; a flag is a number of 0-1.
template <typename Hello>
struct Key {
  std::string_view key;
  std::variant<int Hello::*, std::uint32_t Hello::*, std::uint64_t Hello::*,
               std::optional<std::uint64_t> Hello::*, bool Hello::*, std::optional<bool> Hello::*,
               std::string Hello::*>
      member;
  std::uint64_t min = 0;  ///< of a number
  std::uint64_t max = 1;
  bool always = false;  ///< written even when it has the default
  Kind kind = Kind::Number;
};

/// These two only bound the digits: a server grants less than a client may ask for.
constexpr std::uint64_t kVersionAskedMax = 999'999;
constexpr std::uint64_t kWindowAskedMax = 999'999;

// The tables of PROTOCOL.md, in the order in which we write the keys.

using Asked = HelloAsked;
constexpr Key<Asked> kAskedKeys[] = {
    {.key = "v", .member = &Asked::version, .max = kVersionAskedMax, .always = true},
    {.key = "window", .member = &Asked::window, .max = kWindowAskedMax, .always = true},
    {.key = "stream", .member = &Asked::stream, .kind = Kind::Name},
    {.key = "token", .member = &Asked::token, .kind = Kind::Token},
    {.key = "delta", .member = &Asked::delta},
    {.key = "from", .member = &Asked::from_ms, .max = kPlaceMsMax},
    {.key = "voice", .member = &Asked::voice, .kind = Kind::Name},
    {.key = "text", .member = &Asked::text},
    {.key = "loop", .member = &Asked::loop},
    {.key = "relay", .member = &Asked::relay, .kind = Kind::ServerId},
    {.key = "publish", .member = &Asked::publish, .kind = Kind::Name},
    {.key = "takes", .member = &Asked::takes},
};

using Granted = HelloGranted;
constexpr Key<Granted> kGrantedKeys[] = {
    {.key = "v", .member = &Granted::version, .max = kVersionAskedMax, .always = true},
    {.key = "window", .member = &Granted::window, .max = kWindowMax, .always = true},
    {.key = "delta", .member = &Granted::delta},
    {.key = "stream", .member = &Granted::stream, .kind = Kind::Name},
    {.key = "live", .member = &Granted::live},
    {.key = "duration", .member = &Granted::duration_ms, .max = kPlaceMsMax},
    {.key = "keyframe",
     .member = &Granted::keyframe_ms,
     .min = 1,
     .max = kKeyframeTimeMsMax,
     .always = true},
    {.key = "from", .member = &Granted::from_ms, .max = kPlaceMsMax},
    {.key = "voice", .member = &Granted::voice, .kind = Kind::Name},
    {.key = "text", .member = &Granted::text},
    {.key = "loop", .member = &Granted::loop},
    {.key = "title", .member = &Granted::title, .kind = Kind::Text},
    {.key = "origin", .member = &Granted::servers, .kind = Kind::Servers},
};

constexpr Key<StreamsAsked> kListKeys[] = {
    {.key = "token", .member = &StreamsAsked::token, .kind = Kind::Token},
    {.key = "details", .member = &StreamsAsked::details},
};

/// Of a list with details; with this one a stream begins.
constexpr Key<ListedStream> kListedName = {
    .key = "stream", .member = &ListedStream::name, .kind = Kind::Name};
constexpr Key<ListedStream> kListedKeys[] = {
    kListedName,
    {.key = "live", .member = &ListedStream::live},
    {.key = "duration", .member = &ListedStream::duration_ms, .max = kPlaceMsMax},
    {.key = "title", .member = &ListedStream::title, .kind = Kind::Text},
};

bool is_of(Kind kind, std::string_view value) {
  if (kind == Kind::Name) return is_stream_name(value);
  if (kind == Kind::ServerId) return is_server_id(value);
  if (kind == Kind::Servers) return is_server_chain(value);
  return is_field_value(value) && value.size() <= kTokenBytesMax;
}

/// The string that a value stands for; nullopt when it is not of this kind.
std::optional<std::string> string_of(Kind kind, std::string_view value) {
  if (kind == Kind::Text) {
    auto text = from_base64(value);
    return !value.empty() && text && is_title(*text) ? text : std::nullopt;
  }
  return is_of(kind, value) ? std::optional<std::string>(value) : std::nullopt;
}

/// Puts the value into the hello; false when the key cannot have it.
template <typename Hello>
bool read_value(const Key<Hello>& key, std::string_view text, Hello& hello) {
  return std::visit(
      [&](auto member) {
        auto& value = hello.*member;
        using Value = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, std::string>) {
          auto string = string_of(key.kind, text);
          if (!string) return false;
          value = *std::move(string);
        } else {
          const auto number =
              text.size() > kNumberDigitsMax ? std::nullopt : number_of<std::uint64_t>(text);
          if (!number || *number < key.min || *number > key.max) return false;
          value = static_cast<Value>(*number);
        }
        return true;
      },
      key.member);
}

/// What a value must be, for the message; a token is not quoted.
template <typename Hello>
std::string rule_of(const Key<Hello>& key, std::string_view found) {
  const std::string name(key.key);
  if (key.kind == Kind::Token) {
    return name + " is longer than " + std::to_string(kTokenBytesMax) + " bytes";
  }
  if (key.kind == Kind::Text) {
    return name + " is base64 of at most " + std::to_string(kTitleBytesMax) + " bytes of text";
  }
  if (key.kind == Kind::ServerId || key.kind == Kind::Servers) {
    return name + " has IDs of 1-" + std::to_string(kServerIdBytesMax) +
           " letters, digits, '.', '_' or '-', found '" + escaped(found) + "'";
  }
  return name +
         (key.kind == Kind::Name
              ? std::string(" is a name of ") + kStreamNameRule
              : " is a number of " + std::to_string(key.min) + "-" + std::to_string(key.max)) +
         ", found '" + escaped(found) + "'";
}

/// A piece that is key=value.
struct Field {
  std::string_view key;
  std::string_view value;
  std::size_t value_position = 0;  ///< as that of a piece
};

std::variant<Field, FieldFault> field_of(const Piece& piece) {
  const std::size_t equals = piece.text.find('=');
  if (equals == 0 || equals == std::string_view::npos) {
    return FieldFault{piece.position, "expected key=value, found '" + escaped(piece.text) + "'"};
  }
  return Field{piece.text.substr(0, equals), piece.text.substr(equals + 1),
               piece.position + equals + 1};
}

/// Takes the field into the hello if its key is one of these; the fault, if that cannot be read.
template <typename Hello, std::size_t N>
std::optional<FieldFault> take_field(const Field& field, const Key<Hello> (&keys)[N],
                                     Hello& hello) {
  const auto* key =
      std::find_if(std::begin(keys), std::end(keys),
                   [&field](const Key<Hello>& known) { return known.key == field.key; });
  if (key == std::end(keys) || read_value(*key, field.value, hello)) return std::nullopt;
  return FieldFault{field.value_position, rule_of(*key, field.value)};
}

template <typename Hello, std::size_t N>
std::variant<Hello, FieldFault> parse_fields(std::string_view text, const Key<Hello> (&keys)[N]) {
  std::vector<Field> fields;
  for (const Piece& piece : pieces_after_word(text)) {
    const auto read = field_of(piece);
    if (const auto* const fault = std::get_if<FieldFault>(&read)) return *fault;
    fields.push_back(std::get<Field>(read));
  }
  Hello hello;
  // First the version: in another one the other fields may mean something else.
  for (const bool version : {true, false}) {
    for (const Field& field : fields) {
      if (version != (field.key == "v")) continue;
      if (auto fault = take_field(field, keys, hello)) return *std::move(fault);
    }
    if constexpr (!std::is_same_v<Hello, StreamsAsked>) {
      if (hello.version != kProtocolVersion) return hello;
    }
  }
  return hello;
}

/// The text of a value; nullopt when it is the default or cannot be written in a field.
template <typename Hello>
std::optional<std::string> value_text(const Key<Hello>& key, const Hello& hello) {
  return std::visit(
      [&](auto member) -> std::optional<std::string> {
        const auto& value = hello.*member;
        if (!key.always && value == Hello{}.*member) return std::nullopt;
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, std::string>) {
          std::string text = key.kind == Kind::Text ? to_base64(value) : value;
          return string_of(key.kind, text) ? std::optional(std::move(text)) : std::nullopt;
        } else if constexpr (std::is_same_v<Value, std::optional<std::uint64_t>> ||
                             std::is_same_v<Value, std::optional<bool>>) {
          return std::to_string(static_cast<std::uint64_t>(*value));
        } else {
          return std::to_string(static_cast<std::uint64_t>(value));
        }
      },
      key.member);
}

/// " key=value" for each.
template <typename Hello, std::size_t N>
std::string fields_text(const Hello& hello, const Key<Hello> (&keys)[N]) {
  std::string text;
  for (const Key<Hello>& key : keys) {
    if (const auto value = value_text(key, hello)) {
      text.append(" ").append(key.key).append("=").append(*value);
    }
  }
  return text;
}

template <typename Hello, std::size_t N>
std::string encode_fields(std::string_view word, const Hello& hello, const Key<Hello> (&keys)[N]) {
  return '{' + std::string(word) + fields_text(hello, keys) + '}';
}

std::variant<StreamList, FieldFault> parse_names(const std::vector<Piece>& pieces) {
  StreamList list;
  for (const Piece& piece : pieces) {
    if (!is_stream_name(piece.text)) {
      return FieldFault{piece.position, "'" + escaped(piece.text) + "' is no stream's name"};
    }
    list.streams.push_back({std::string(piece.text)});
  }
  return list;
}

std::variant<StreamList, FieldFault> parse_details(const std::vector<Piece>& pieces) {
  StreamList list;
  for (const Piece& piece : pieces) {
    const auto read = field_of(piece);
    if (const auto* const fault = std::get_if<FieldFault>(&read)) return *fault;
    const Field& field = std::get<Field>(read);
    if (field.key == kListedName.key) list.streams.emplace_back();
    if (list.streams.empty()) continue;  // of the list itself, of which nothing is said yet
    if (auto fault = take_field(field, kListedKeys, list.streams.back())) return *std::move(fault);
  }
  return list;
}

std::string encode_names(const StreamList& list) {
  std::string text = "{streams";
  for (const ListedStream& stream : list.streams) {
    if (!is_stream_name(stream.name)) continue;
    if (text.size() + stream.name.size() + 2 > kPacketBytesMax) break;
    text += ' ' + stream.name;
  }
  return text + '}';
}

/// Whether anything but the name is known.
bool has_details(const ListedStream& stream) {
  return stream.live || stream.duration_ms || !stream.title.empty();
}

/// With all streams; nothing when there is no room for them, or nothing to say of them.
std::optional<std::string> encode_details(const StreamList& list, bool titles) {
  std::string text = "{streams";
  bool any = false;
  for (ListedStream stream : list.streams) {
    if (!is_stream_name(stream.name)) continue;
    if (!titles) stream.title.clear();
    any = any || has_details(stream);
    text += fields_text(stream, kListedKeys);
    if (text.size() + 1 > kPacketBytesMax) return std::nullopt;
  }
  return any ? std::optional(text + '}') : std::nullopt;
}

/// A byte of an error's text: what cannot stand in a packet, replaced. A backslash is let through
/// alone: the text often quotes what has been escaped before.
std::string printable(char byte) {
  if (byte == '{') return "(";
  if (byte == '}') return ")";
  if (byte == '\\') return "\\";
  return escaped(std::string_view(&byte, 1));
}

}  // namespace

std::optional<ByteFault> WordPacket::accept(char byte) {
  if (word_bytes_ == 0) {
    const bool complete =
        std::find(words_.begin(), words_.end(), std::string_view(text_)) != words_.end();
    const bool ends_word = byte == ' ' || (byte == '@' && text_.size() == 1);
    if (complete && ends_word) {
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
  return parse_fields(text, kAskedKeys);
}

std::variant<HelloGranted, FieldFault> parse_hello_granted(std::string_view text) {
  return parse_fields(text, kGrantedKeys);
}

std::variant<StreamsAsked, FieldFault> parse_streams_asked(std::string_view text) {
  return parse_fields(text, kListKeys);
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
  const std::vector<Piece> pieces = pieces_after_word(text);
  // A name has no '='.
  const bool details = !pieces.empty() && pieces.front().text.find('=') != std::string_view::npos;
  return details ? parse_details(pieces) : parse_names(pieces);
}

std::string encode(const HelloAsked& hello) {
  return encode_fields("hello", hello, kAskedKeys);
}

std::string encode(const HelloGranted& hello) {
  return encode_fields("hello", hello, kGrantedKeys);
}

std::string encode(const StreamsAsked& asked) {
  return encode_fields("streams", asked, kListKeys);
}

std::string encode(const ErrorReply& error) {
  std::string text = "{error " + std::to_string(error.code) + ' ';
  constexpr std::string_view kCut = "...}";
  for (const char byte : error.text) {
    std::string piece = printable(byte);
    if (text.size() + piece.size() + kCut.size() > kHelloBytesMax) return text.append(kCut);
    text += piece;
  }
  return text + '}';
}

std::string encode(const StreamList& list) {
  for (const bool titles : {true, false}) {
    if (auto text = encode_details(list, titles)) return *std::move(text);
  }
  return encode_names(list);
}

}  // namespace aucast::protocol
