#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/keyframe_parser.h"

namespace aucast::protocol {
namespace {

constexpr std::string_view kTextBlanks = " \t\r\n";

Error au_set_error(std::string_view text, std::size_t position, const std::string& reason) {
  return {ErrorKind::Usage,
          "AU set '" + escaped(text) + "', column " + std::to_string(position + 1) + ": " + reason};
}

/// The text without blanks around it and without one pair of braces; `shift` says how many bytes
/// were cut in front. Nothing when only one of the braces is there.
std::optional<std::string_view> without_braces(std::string_view text, std::size_t& shift) {
  shift = std::min(text.find_first_not_of(kTextBlanks), text.size());
  text.remove_prefix(shift);
  text = text.substr(0, text.find_last_not_of(kTextBlanks) + 1);
  const bool opened = text.starts_with('{');
  const bool closed = text.ends_with('}');
  if (opened != closed) return std::nullopt;
  if (!opened) return text;
  ++shift;
  return text.substr(1, text.size() - 2);
}

}  // namespace

std::optional<TextError> parse_keyframe(std::string_view text, TermSyntax syntax, Keyframe& out) {
  KeyframeParser parser(syntax);
  for (std::size_t position = 0; position < text.size(); ++position) {
    if (auto fault = parser.accept(text[position])) {
      return TextError{position, std::move(fault->reason)};
    }
  }
  if (auto fault = parser.finish(0)) return TextError{text.size(), std::move(fault->reason)};
  out = parser.take();
  return std::nullopt;
}

Result<AuFrame> parse_au_set(std::string_view text) {
  std::size_t shift = 0;
  const std::optional<std::string_view> inside = without_braces(text, shift);
  if (!inside) {
    return au_set_error(text, shift, "one brace is missing; write {1,6,12} or 1,6,12");
  }
  Keyframe keyframe;
  if (const auto error = parse_keyframe(*inside, TermSyntax::Text, keyframe)) {
    return au_set_error(text, shift + error->position, error->reason);
  }
  if (keyframe.changes_only) {
    return au_set_error(text, shift + inside->find('~'),
                        "changes only ('~') have a meaning in a stream; name the whole set");
  }
  if (keyframe.duration_ms) {
    return au_set_error(text, shift + inside->find(';'),
                        "a time (';') has a meaning in a stream; name the AUs alone");
  }
  return frame_from_terms(keyframe.terms);
}

}  // namespace aucast::protocol
