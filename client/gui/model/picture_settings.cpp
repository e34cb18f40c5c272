#include "client/gui/model/picture_settings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "client/gui/texts/texts.h"
#include "common/text.h"

namespace aucast::gui {
namespace {

constexpr std::size_t kWordMax = 80;

/// The word as part of a file's name that works on all systems.
std::string in_a_name(std::string word) {
  if (word.empty()) return "none";
  for (char& c : word) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       c == '.' || c == '_' || (static_cast<unsigned char>(c) & 0x80U) != 0;
    if (!plain) c = '-';
  }
  if (word.size() > kWordMax) {
    std::size_t end = kWordMax;
    while (end > 0 && is_continuation(word[end])) --end;
    word.resize(end);  // between two characters
  }
  return word;
}

Error wrong(const std::string& what) {
  return {ErrorKind::Usage, tr("pattern.wrong", what)};
}

}  // namespace

Result<std::string> picture_name(std::string_view pattern, const PictureWords& words, int number) {
  const std::array<std::pair<std::string_view, std::string>, 6> known{
      {{"number", std::to_string(number)},
       {"face", words.face},
       {"stream", words.stream},
       {"keyframe", words.keyframe},
       {"aus", words.aus},
       {"date", words.date}}};
  std::string name;
  while (!pattern.empty()) {
    const std::size_t open = std::min(pattern.find('{'), pattern.size());
    name += pattern.substr(0, open);
    pattern.remove_prefix(open);
    if (pattern.empty()) break;
    const std::size_t close = pattern.find('}');
    if (close == std::string_view::npos) return wrong(tr("pattern.open", "{", "}"));
    const std::string_view word = pattern.substr(1, close - 1);
    const auto found = std::find_if(known.begin(), known.end(),
                                    [word](const auto& one) { return one.first == word; });
    if (found == known.end()) {
      return wrong(tr("pattern.unknown", "{" + escaped(std::string(word)) + "}",
                      "{number}, {face}, {stream}, {keyframe}, {aus}, {date}"));
    }
    name += in_a_name(found->second);
    pattern.remove_prefix(close + 1);
  }
  if (name.empty()) return wrong(tr("pattern.empty"));
  if (name.find('/') != std::string::npos) return wrong(tr("pattern.folder"));
  if (name.front() == '.') return wrong(tr("pattern.hidden"));
  return name;
}

}  // namespace aucast::gui
