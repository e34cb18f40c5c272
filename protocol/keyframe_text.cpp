#include <algorithm>
#include <vector>

#include "common/action_unit.h"
#include "common/text.h"
#include "common/text_file.h"
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
/// were cut in front. nullopt when only one of the braces is there.
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

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// "Left Lip Corner Puller" as a term: "L12". nullopt for a name that FACS does not have.
std::optional<std::string> term_of_name(std::string_view name) {
  std::string side;
  auto number = facs_number(name);
  for (const std::string_view word : {"left ", "l ", "right ", "r "}) {
    if (number || name.size() <= word.size()) continue;
    const bool same = std::equal(word.begin(), word.end(), name.begin(), [](char a, char b) {
      return a == b || (is_letter(b) && a == static_cast<char>(b | 0x20));
    });
    if (!same) continue;
    number = facs_number(name.substr(word.size()));
    side = word.front() == 'l' ? "L" : "R";
  }
  if (!number) return std::nullopt;
  return side + std::to_string(*number);
}

/// A set with numbers where FACS names stood: "Inner Brow Raiser:50,12" is "1:50,12".
struct NumberedSet {
  std::string text;
  std::vector<std::size_t> origins;  ///< where each of its characters, and its end, was typed
  void add(std::string_view same, std::size_t at) {
    for (const char c : same) {
      text += c;
      origins.push_back(at++);
    }
  }
};

Result<NumberedSet> with_numbers(std::string_view text) {
  NumberedSet numbers;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(",+;{}", at), text.size());
    const std::size_t name_end = std::min(text.find(':', at), end);
    const std::string_view name = text.substr(at, name_end - at);
    if (std::count_if(name.begin(), name.end(), is_letter) < 3) {
      numbers.add(name, at);
    } else if (const auto term = term_of_name(trimmed(name, kTextBlanks))) {
      const std::size_t begin = at + name.find_first_not_of(kTextBlanks);
      numbers.text += *term;
      numbers.origins.insert(numbers.origins.end(), term->size(), begin);
    } else {
      return au_set_error(text, at,
                          "'" + escaped(trimmed(name, kTextBlanks)) +
                              "' is not the FACS name of an AU, such as Inner Brow Raiser");
    }
    numbers.add(text.substr(name_end, end + 1 - name_end), name_end);
    at = end + 1;
  }
  numbers.origins.push_back(text.size());
  return numbers;
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

Result<AuFrame> parse_au_set(std::string_view typed) {
  const auto numbers = with_numbers(typed);
  if (!numbers) return numbers.error();
  const std::string_view text = numbers->text;
  const auto wrong = [&](std::size_t position, const std::string& reason) {
    return au_set_error(typed, numbers->origins[position], reason);
  };
  std::size_t shift = 0;
  const std::optional<std::string_view> inside = without_braces(text, shift);
  if (!inside) {
    return wrong(shift, "one brace is missing; write {1,6,12} or 1,6,12");
  }
  Keyframe keyframe;
  if (const auto error = parse_keyframe(*inside, TermSyntax::Text, keyframe)) {
    return wrong(shift + error->position, error->reason);
  }
  if (keyframe.changes_only) {
    return wrong(shift + inside->find('~'),
                 "changes only ('~') have a meaning in a stream; name the whole set");
  }
  if (keyframe.time_ms) {
    return wrong(shift + inside->find(';'),
                 "a time (';') has a meaning in a stream; name the AUs alone");
  }
  return frame_from_terms(keyframe.terms);
}

}  // namespace aucast::protocol
