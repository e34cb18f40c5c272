#include "client/gui/storage/language_file.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/action_unit.h"
#include "common/error_list.h"
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

/// The rows of the table whose keys begin with the name of this section, by the rest of the key.
std::map<std::string_view, std::size_t> rows_of(std::string_view section) {
  std::map<std::string_view, std::size_t> rows;
  for (std::size_t row = 0; row < kEnglish.size(); ++row) {
    const std::string_view key = kEnglish[row].key;
    const std::size_t point = key.find('.');
    if (key.substr(0, point) == section) rows.emplace(key.substr(point + 1), row);
  }
  return rows;
}

/// Why the entry cannot stand in for this English text; empty: it can.
std::string fault_of(const TomlValue::Entry& entry, std::string_view english) {
  if (entry.value.kind != TomlValue::Kind::Text) return entry.key + " must be a text";
  const auto wanted = as_set(places_of(english));
  const auto there = as_set(places_of(entry.value.text));
  if (wanted == there) return {};
  return entry.key + " has the places " + joined(there) + " where the English has " +
         joined(wanted);
}

/// One [section] of the file.
void read_section(const TomlValue& table, std::string_view section, ErrorList& left_out,
                  Language& language) {
  auto missing = rows_of(section);
  const auto keys = missing;
  for (const TomlValue::Entry& entry : table.entries) {
    const auto row = keys.find(entry.key);
    if (row == keys.end()) {
      left_out.add(entry.place.line, entry.place.column,
                   "unknown key '" + escaped(entry.key) + "'");
      continue;
    }
    missing.erase(entry.key);
    const std::string fault = fault_of(entry, kEnglish[row->second].text);
    if (fault.empty()) {
      language.texts[row->second] = entry.value.text;
    } else {
      left_out.add(entry.value.place.line, entry.value.place.column, fault);
    }
  }
  for (const auto& [key, row] : missing) {
    left_out.add(table.place.line, table.place.column, "'" + std::string(key) + "' is missing");
  }
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

Result<LoadedLanguage> load_language(const std::filesystem::path& file) {
  const auto document = read_toml(file);
  if (!document) return document.error();
  const std::string name = file.string();
  Problems problems(name);
  ErrorList left_out(name);
  TableReader reader(*document, problems);
  Language language;
  language.name = reader.text("name");
  for (const EnglishText& one : kEnglish) language.texts.emplace_back(one.text);
  for (const std::string_view section : sections()) {
    const TomlValue* table = reader.table_if(section);
    if (table != nullptr) {
      read_section(*table, section, left_out, language);
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
  return LoadedLanguage{std::move(language), left_out.take()};
}

}  // namespace aucast::gui
