#include "client/gui/texts.h"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

#include "common/action_unit.h"
#include "common/number_of.h"
#include "common/text.h"
#include "common/toml_document.h"
#include "common/toml_reader.h"

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

/// The names of the places, in their order.
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

std::string joined(const std::set<std::string_view>& places) {
  if (places.empty()) return "none";
  std::string text;
  for (const std::string_view place : places) {
    text += (text.empty() ? "{" : ", {") + std::string(place) + "}";
  }
  return text;
}

std::set<std::string_view> as_set(const std::vector<std::string_view>& places) {
  return {places.begin(), places.end()};
}

/// One [section] of the file, which has the texts whose keys begin with its name.
void read_section(const TomlValue& table, std::string_view section, Problems& problems,
                  Language& language) {
  TableReader reader(table, problems);
  for (std::size_t row = 0; row < kEnglish.size(); ++row) {
    const std::string_view whole = kEnglish[row].key;
    const std::size_t point = whole.find('.');
    if (whole.substr(0, point) != section) continue;
    const std::string_view key = whole.substr(point + 1);
    language.texts[row] = reader.text(key);
    const auto wanted = as_set(places_of(kEnglish[row].text));
    const auto there = as_set(places_of(language.texts[row]));
    if (wanted == there || !reader.has(key)) continue;
    reader.wrong(key,
                 "has the places " + joined(there) + " where the English has " + joined(wanted));
  }
  reader.finish();
}

std::map<int, std::string> read_numbered(const TomlValue* table, Problems& problems) {
  std::map<int, std::string> texts;
  if (table == nullptr) return texts;
  TableReader reader(*table, problems);
  for (const TomlValue::Entry& entry : table->entries) {
    const int number = number_of<int>(entry.key).value_or(-1);
    if (number < 0 || number > kAuNumberMax) {
      problems.add(entry.place, "'" + escaped(entry.key) + "' is not an AU number, 0 to 99");
    }
    texts[number] = reader.text(entry.key);
  }
  return texts;
}

std::set<std::string_view> sections() {
  std::set<std::string_view> names;
  for (const EnglishText& one : kEnglish) {
    const std::string_view key = one.key;
    names.insert(key.substr(0, key.find('.')));
  }
  return names;
}

}  // namespace

Result<Language> load_language(const std::filesystem::path& file) {
  const auto document = read_toml(file);
  if (!document) return document.error();
  Problems problems(file.string());
  TableReader reader(*document, problems);
  Language language;
  language.name = reader.text("name");
  language.texts.resize(kEnglish.size());
  for (const std::string_view section : sections()) {
    const TomlValue* table = reader.table_if(section);
    if (table != nullptr) {
      read_section(*table, section, problems, language);
    } else {
      problems.add(document->place, "no [" + std::string(section) + "] in it");
    }
  }
  language.au_names = read_numbered(reader.table_if("au_names"), problems);
  language.au_looks = read_numbered(reader.table_if("au_looks"), problems);
  if (const TomlValue* table = reader.table_if("words")) {
    TableReader words(*table, problems);
    for (const TomlValue::Entry& entry : table->entries) {
      language.words[entry.key] = words.text(entry.key);
    }
  }
  reader.finish();
  if (auto good = problems.result(); !good) return good.error();
  return language;
}

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
