#include "server/settings/settings.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "common/text.h"
#include "common/toml_writer.h"

namespace aucast::server {
namespace {

using Kind = OptionValue::Kind;

constexpr std::string_view kVariablePrefix = "AUCAST_TRANSMITTER_";

bool is_setting(const OptionRow& row) {
  return row.where != OptionRow::Where::Typed;
}

/// "AUCAST_TRANSMITTER_CLIENT_TIMEOUT".
std::string variable_name(const OptionRow& row) {
  std::string name(kVariablePrefix);
  for (const char c : row.option.name) {
    name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return name;
}

/// A value of the file as the command line would have it; nullopt: it is of another type.
std::optional<std::string> word_of(const TomlValue& value, Kind kind) {
  switch (value.kind) {
    case TomlValue::Kind::Boolean:
      if (kind == Kind::Flag) return value.boolean ? "true" : "false";
      break;
    case TomlValue::Kind::Integer:
      if (kind == Kind::Number) return std::to_string(value.integer);
      break;
    case TomlValue::Kind::Real:
      if (kind == Kind::Number) return number_text(value.real);
      break;
    case TomlValue::Kind::Text:
      if (kind != Kind::Flag) return value.text;
      break;
    default:
      break;
  }
  return std::nullopt;
}

std::optional<std::vector<std::string>> words_of(const TomlValue& value, Kind kind) {
  std::vector<std::string> words;
  if (kind == Kind::Words && value.kind == TomlValue::Kind::Array) {
    for (const TomlValue& item : value.items) {
      auto word = word_of(item, kind);
      if (!word) return std::nullopt;
      words.push_back(std::move(*word));
    }
    return words;
  }
  auto word = word_of(value, kind);
  if (!word) return std::nullopt;
  words.push_back(std::move(*word));
  return words;
}

std::string_view type_name(Kind kind) {
  switch (kind) {
    case Kind::Flag:
      return "true or false";
    case Kind::Number:
      return "a number";
    case Kind::Word:
      return "a string in quotes";
    case Kind::Words:
      return "a string in quotes, or a list of them in brackets";
  }
  return "";
}

std::string unknown_option(std::string_view said, const std::vector<std::string>& known) {
  std::string text = "'" + escaped(said) + "' is none of the settings";
  if (const auto near = nearest(said, known)) text += "; did you mean '" + *near + "'?";
  return text;
}

template <typename NameOf>
std::vector<std::string> names_of_settings(const std::vector<OptionRow>& rows, NameOf name_of) {
  std::vector<std::string> names;
  for (const OptionRow& row : rows) {
    if (is_setting(row)) names.emplace_back(name_of(row));
  }
  return names;
}

}  // namespace

Settings::Settings(const std::vector<OptionRow>& rows) : rows_(rows) {
  for (const OptionRow& row : rows) {
    const bool is_flag = row.value.kind == Kind::Flag;
    if (!is_setting(row) || (row.option.fallback.empty() && !is_flag)) continue;
    settings_[std::string(row.option.name)].words = {is_flag ? "false"
                                                             : std::string(row.option.fallback)};
  }
}

Result<void> Settings::add_file(std::string_view text, const std::string& file) {
  const auto document = parse_toml(text, file);
  if (!document) return document.error();
  for (const TomlValue::Entry& entry : document->entries) {
    const auto bad = [&](const LinePosition& place, const std::string& why) {
      return Error{ErrorKind::BadData, at_place(file, place.line, place.column, why)};
    };
    const OptionRow* row = find_row(rows_, entry.key);
    if (row == nullptr) {
      const auto known =
          names_of_settings(rows_, [](const OptionRow& other) { return other.option.name; });
      return bad(entry.place, unknown_option(entry.key, known));
    }
    if (!is_setting(*row))
      return bad(entry.place, "'" + entry.key + "' is for the command line only");
    auto words = words_of(entry.value, row->value.kind);
    if (!words) {
      return bad(entry.value.place,
                 entry.key + " is not " + std::string(type_name(row->value.kind)));
    }
    settings_[entry.key] = {std::move(*words), Origin::File, file, entry.value.place};
  }
  return {};
}

Result<void> Settings::add_environment(const Environment& environment) {
  for (const auto& [name, value] : environment) {
    if (!name.starts_with(kVariablePrefix) || value.empty()) continue;
    const auto row = std::find_if(
        rows_.begin(), rows_.end(),
        [&name = name](const OptionRow& other) { return variable_name(other) == name; });
    if (row == rows_.end()) {
      return Error{ErrorKind::Usage,
                   "environment: " + unknown_option(name, names_of_settings(rows_, variable_name))};
    }
    if (row->option.name == "config") continue;  // it has been read to find the file
    if (!is_setting(*row)) {
      return usage_error(name + ": " + typed_name(*row) + " is for the command line only");
    }
    std::vector<std::string> words{value};
    if (row->value.kind == Kind::Words) {
      const auto parts = split(value, ',');
      words.assign(parts.begin(), parts.end());
    }
    settings_[std::string(row->option.name)] = {std::move(words), Origin::Variable};
  }
  return {};
}

void Settings::add_typed(const TypedWords& typed) {
  for (const auto& [name, words] : typed) settings_[name] = {words, Origin::CommandLine};
}

Result<void> Settings::read() const {
  for (const OptionRow& row : rows_) {
    const auto setting = settings_.find(row.option.name);
    if (setting == settings_.end()) continue;
    for (const std::string& word : setting->second.words) {
      if (const Complaint complaint = read_word(row, word)) {
        return wrong(row, setting->second, word, *complaint);
      }
    }
  }
  return {};
}

Error Settings::wrong(const OptionRow& row, const Setting& setting, const std::string& word,
                      const std::string& complaint) {
  if (setting.origin == Origin::File) {
    return {ErrorKind::BadData,
            at_place(setting.file, setting.place.line, setting.place.column,
                     std::string(row.option.name) + " '" + escaped(word) + "' " + complaint)};
  }
  return wrong_word(setting.origin == Origin::Variable ? variable_name(row) : typed_name(row), word,
                    complaint);
}

std::string Settings::value_text(const OptionRow& row, const Setting& setting) {
  if (row.value.kind == Kind::Words) return toml_texts(setting.words);
  const std::string& word = setting.words.front();
  if (row.value.kind == Kind::Flag) return word;
  if (row.value.kind == Kind::Number) {
    if (const auto whole = number_of<std::int64_t>(word)) return std::to_string(*whole);
    if (const auto real = number_of<double>(word)) return number_text(*real);
  }
  return toml_text(word);
}

std::string Settings::origin(const OptionRow& row, const Setting& setting) {
  switch (setting.origin) {
    case Origin::Default:
      return "default";
    case Origin::File:
      return escaped(setting.file, 200) + ":" + std::to_string(setting.place.line);
    case Origin::Variable:
      return "environment " + variable_name(row);
    case Origin::CommandLine:
      return "command line";
  }
  return "";
}

std::string Settings::print() const {
  std::string text = "# Settings of au-transmitter; what --config takes.\n";
  for (const OptionRow& row : rows_) {
    if (!is_setting(row)) continue;
    const auto setting = settings_.find(row.option.name);
    if (setting == settings_.end()) {
      text += "# " + std::string(row.option.name) + " is not set\n";
    } else {
      text += std::string(row.option.name) + " = " + value_text(row, setting->second) + "  # " +
              origin(row, setting->second) + "\n";
    }
  }
  return text;
}

}  // namespace aucast::server
