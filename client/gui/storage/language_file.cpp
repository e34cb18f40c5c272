#include "client/gui/storage/language_file.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/number_of.h"
#include "common/text.h"
#include "common/toml_document.h"
#include "common/toml_reader.h"

namespace aucast::gui {
namespace {

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

}  // namespace aucast::gui
