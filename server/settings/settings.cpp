#include "server/settings/settings.h"

#include <algorithm>
#include <optional>

#include "common/text.h"

namespace aucast::server {
namespace {

using Kind = OptionRow::Kind;

constexpr std::string_view kVariablePrefix = "AUCAST_TRANSMITTER_";

bool is_setting(const OptionRow& row) {
  return row.read != nullptr;
}

/// A value of the file as the word that the command line would have; nothing: of another type.
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
std::vector<std::string> names_of_settings(NameOf name_of) {
  std::vector<std::string> names;
  for (const OptionRow& row : option_table()) {
    if (is_setting(row)) names.emplace_back(name_of(row));
  }
  return names;
}

/// What is said about a wrong word, by where it was said.
Error wrong_word(const OptionRow& row, const Setting& setting, const std::string& word,
                 const std::string& complaint) {
  if (setting.layer == Setting::Layer::File) {
    return {ErrorKind::BadData,
            at_place(setting.file, setting.place.line, setting.place.column,
                     std::string(row.name) + " '" + escaped(word) + "' " + complaint)};
  }
  const std::string name =
      setting.layer == Setting::Layer::Environment ? variable_name(row) : typed_name(row);
  if (word.empty()) return {ErrorKind::Usage, name + " is empty (try --help)"};
  return {ErrorKind::Usage, name + " '" + escaped(word) + "' " + complaint + " (try --help)"};
}

/// A TOML string; our own words hold what a command line can hold, which is anything but NUL.
std::string toml_string(std::string_view word) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string text = "\"";
  for (const char c : word) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text += {'\\', c};
    } else if (code < 0x20 || code == 0x7f) {
      text += {'\\', 'u', '0', '0', kHex[code >> 4U], kHex[code & 15U]};
    } else {
      text += c;
    }
  }
  return text + "\"";
}

std::string value_text(const OptionRow& row, const Setting& setting) {
  if (row.kind == Kind::Words) {
    std::string text = "[";
    for (const std::string& word : setting.words) {
      if (text.size() > 1) text += ", ";
      text += toml_string(word);
    }
    return text + "]";
  }
  const std::string& word = setting.words.front();
  if (row.kind == Kind::Flag) return word;
  if (row.kind == Kind::Number) {
    if (const auto whole = number_of<std::int64_t>(word)) return std::to_string(*whole);
    if (const auto real = number_of<double>(word)) return number_text(*real);
  }
  return toml_string(word);
}

std::string origin(const OptionRow& row, const Setting& setting) {
  switch (setting.layer) {
    case Setting::Layer::Default:
      return "default";
    case Setting::Layer::File:
      return escaped(setting.file, 200) + ":" + std::to_string(setting.place.line);
    case Setting::Layer::Environment:
      return "environment " + variable_name(row);
    case Setting::Layer::CommandLine:
      return "command line";
  }
  return "";
}

}  // namespace

Settings default_settings() {
  Settings settings;
  for (const OptionRow& row : option_table()) {
    if (!is_setting(row) || row.fallback.empty()) continue;
    settings[std::string(row.name)].words = {std::string(row.fallback)};
  }
  return settings;
}

Result<void> add_file(Settings& settings, std::string_view text, const std::string& file) {
  const auto document = parse_toml(text, file);
  if (!document) return document.error();
  for (const TomlValue::Entry& entry : document->entries) {
    const auto bad = [&](const Place& place, const std::string& why) {
      return Error{ErrorKind::BadData, at_place(file, place.line, place.column, why)};
    };
    const OptionRow* row = find_option(entry.key);
    if (row == nullptr || !is_setting(*row)) {
      const auto known = names_of_settings([](const OptionRow& other) { return other.name; });
      return bad(entry.place, row == nullptr ? unknown_option(entry.key, known)
                                             : "'" + entry.key + "' is for the command line only");
    }
    auto words = words_of(entry.value, row->kind);
    if (!words) {
      return bad(entry.value.place, entry.key + " is not " + std::string(type_name(row->kind)));
    }
    settings[entry.key] = {std::move(*words), Setting::Layer::File, file, entry.value.place};
  }
  return {};
}

Result<void> add_environment(Settings& settings, const Environment& environment) {
  for (const auto& variable : environment) {
    const std::string& name = variable.first;
    const std::string& value = variable.second;
    if (!name.starts_with(kVariablePrefix) || value.empty()) continue;
    const auto rows = option_table();
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const OptionRow& other) {
      return variable_name(other) == name;
    });
    if (row == rows.end()) {
      return Error{ErrorKind::Usage,
                   "environment: " + unknown_option(name, names_of_settings(variable_name))};
    }
    if (row->name == "config") continue;  // it has been read to find the file
    if (!is_setting(*row)) {
      return Error{ErrorKind::Usage,
                   name + ": " + typed_name(*row) + " is for the command line only (try --help)"};
    }
    std::vector<std::string> words{value};
    if (row->kind == Kind::Words) {
      const auto parts = split(value, ',');
      words.assign(parts.begin(), parts.end());
    }
    settings[std::string(row->name)] = {std::move(words), Setting::Layer::Environment, {}, {}};
  }
  return {};
}

Result<TransmitterOptions> options_of(const Settings& settings) {
  TransmitterOptions options;
  for (const OptionRow& row : option_table()) {
    const auto setting = settings.find(row.name);
    if (setting == settings.end() || !is_setting(row)) continue;
    for (const std::string& word : setting->second.words) {
      // An empty word is what `--stats "$UNSET"` leaves behind: silence would hide the slip.
      const Complaint wrong = word.empty() ? "is empty" : row.read(word, options);
      if (wrong) return wrong_word(row, setting->second, word, *wrong);
    }
  }
  return options;
}

std::string print_config(const Settings& settings) {
  std::string text = "# Settings of au-transmitter; what --config takes.\n";
  for (const OptionRow& row : option_table()) {
    if (!is_setting(row)) continue;
    const auto setting = settings.find(row.name);
    if (setting == settings.end()) {
      text += "# " + std::string(row.name) + " is not set\n";
    } else {
      text += std::string(row.name) + " = " + value_text(row, setting->second) + "  # " +
              origin(row, setting->second) + "\n";
    }
  }
  return text;
}

}  // namespace aucast::server
