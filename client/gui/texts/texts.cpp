#include "client/gui/texts/texts.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "common/action_unit.h"

namespace aucast::gui {
namespace {

/// Null: English. Languages that were used are kept, because their texts were handed out.
const Language*& used() {
  static const Language* language = nullptr;
  return language;
}

std::string_view text_of(std::size_t row) {
  return used() == nullptr ? std::string_view(kEnglish[row].text) : used()->texts[row];
}

}  // namespace

void use_language(Language language) {
  static std::deque<Language> kept;
  const auto before = std::find(kept.begin(), kept.end(), language);
  used() = before != kept.end() ? &*before : &kept.emplace_back(std::move(language));
}

void use_english() {
  used() = nullptr;
}

bool other_language() {
  return used() != nullptr;
}

const char* tr(TextKey key) {
  return text_of(key.row()).data();
}

std::vector<std::string_view> places_of(std::string_view text) {
  std::vector<std::string_view> places;
  for (std::size_t open = text.find('{'); open != std::string_view::npos;) {
    const std::size_t close = text.find('}', open);
    if (close == std::string_view::npos) {
      places.push_back(text.substr(open));
      break;
    }
    places.push_back(text.substr(open + 1, close - open - 1));
    open = text.find('{', close);
  }
  return places;
}

std::string filled(std::size_t row, const std::vector<std::string>& values) {
  const auto names = places_of(kEnglish[row].text);
  const std::string_view text = text_of(row);
  std::string out;
  std::size_t done = 0;
  for (const std::string_view place : places_of(text)) {
    const auto begin = static_cast<std::size_t>(place.data() - text.data()) - 1;
    out += text.substr(done, begin - done);
    done = begin + place.size() + 2;
    const auto name = std::find(names.begin(), names.end(), place);
    if (name != names.end()) out += values[static_cast<std::size_t>(name - names.begin())];
  }
  return out += text.substr(std::min(done, text.size()));
}

std::string au_name(int number, const std::string& own) {
  const std::string english(facs_name(number).value_or(""));
  if (!own.empty() && own != english) return own;
  if (used() == nullptr) return english;
  const auto found = used()->au_names.find(number);
  return found == used()->au_names.end() ? english : found->second;
}

std::string au_looks(int number, const std::string& english) {
  if (used() == nullptr) return english;
  const auto found = used()->au_looks.find(number);
  return found == used()->au_looks.end() ? english : found->second;
}

std::string data_word(const std::string& english) {
  if (used() == nullptr) return english;
  const auto found = used()->words.find(english);
  return found == used()->words.end() ? english : found->second;
}

std::string keyframes_text(std::size_t count) {
  return count == 1 ? std::string(tr("state.one_keyframe")) : tr("state.keyframes", count);
}

std::vector<std::string> all_texts() {
  std::vector<std::string> all;
  for (std::size_t row = 0; row < kEnglish.size(); ++row) all.emplace_back(text_of(row));
  if (used() == nullptr) return all;
  all.push_back(used()->name);
  for (const auto& [number, text] : used()->au_names) all.push_back(text);
  for (const auto& [number, text] : used()->au_looks) all.push_back(text);
  for (const auto& [english, text] : used()->words) all.push_back(text);
  return all;
}

}  // namespace aucast::gui
