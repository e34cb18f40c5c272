#include "common/toml_document.h"

#include <algorithm>
#include <tuple>

#include <toml++/toml.h>

#include "common/files.h"
#include "common/text.h"

namespace aucast {
namespace {

LinePosition place_of(const toml::source_region& region) {
  return {region.begin.line, region.begin.column};
}

// The library limits how deep tables and arrays nest, and with that this recursion.
TomlValue value_of(const toml::node& node) {
  TomlValue value;
  value.place = place_of(node.source());
  if (const auto* table = node.as_table()) {
    value.kind = TomlValue::Kind::Table;
    for (const auto& [key, child] : *table) {
      value.entries.push_back({std::string(key.str()), place_of(key.source()), value_of(child)});
    }
    // The library sorts by name; errors should come in the order of the file.
    std::sort(value.entries.begin(), value.entries.end(), [](const auto& a, const auto& b) {
      return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
  } else if (const auto* array = node.as_array()) {
    value.kind = TomlValue::Kind::Array;
    for (const auto& child : *array) value.items.push_back(value_of(child));
  } else if (const auto* text = node.as_string()) {
    value.kind = TomlValue::Kind::Text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = TomlValue::Kind::Integer;
    value.integer = integer->get();
    value.real = static_cast<double>(value.integer);
  } else if (const auto* real = node.as_floating_point()) {
    value.kind = TomlValue::Kind::Real;
    value.real = real->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = TomlValue::Kind::Boolean;
    value.boolean = boolean->get();
  }
  return value;
}

/// Whether the library says that a key or a table is defined already.
bool says_repeated(std::string_view description) {
  return description.find("cannot redefine existing ") != std::string_view::npos &&
         description.find("' as ") == std::string_view::npos && description.ends_with('\'');
}

/// The repeated key: the library points behind it and its '=', or at the '[' of a table.
TomlValue::Entry repeated_key(std::string_view bytes, LinePosition place) {
  for (std::size_t line = 1; line < place.line; ++line) bytes.remove_prefix(bytes.find('\n') + 1);
  std::string_view key = bytes.substr(0, place.column - 1);
  key = key.substr(0, key.find_last_not_of(" \t=") + 1);
  if (key.empty()) key = bytes.substr(0, bytes.find(']'));
  const std::size_t before = key.find_last_of("[{,") + 1;
  const std::size_t begin = std::min(key.find_first_not_of(" \t", before), key.size());
  const auto column = static_cast<std::size_t>(key.data() + begin - bytes.data()) + 1;
  return {std::string(key.substr(begin)), {place.line, column}, {}};
}

Error error_of(const toml::parse_error& error, std::string_view bytes, std::string_view file) {
  if (!says_repeated(error.description())) {
    const LinePosition place = place_of(error.source());
    return {ErrorKind::BadData,
            at_place(file, place.line, place.column, escaped(error.description(), 200))};
  }
  const TomlValue::Entry again = repeated_key(bytes, place_of(error.source()));
  return {ErrorKind::BadData,
          at_place(file, again.place.line, again.place.column,
                   escaped(again.key) + " is defined a second time; keep one of the two")};
}

}  // namespace

const TomlValue* TomlValue::find(std::string_view key) const {
  for (const Entry& entry : entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

Result<TomlValue> parse_toml(std::string_view bytes, std::string_view file) {
  try {
    return value_of(toml::parse(bytes));
  } catch (const toml::parse_error& error) {
    return error_of(error, bytes, file);
  }
}

Result<TomlValue> read_toml(const std::filesystem::path& path, std::size_t bytes_max) {
  const auto bytes = read_file(path, bytes_max);
  if (!bytes) return bytes.error();
  return parse_toml(*bytes, path.string());
}

}  // namespace aucast
