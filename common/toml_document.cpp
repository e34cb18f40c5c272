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
    const LinePosition place = place_of(error.source());
    return Error{ErrorKind::BadData,
                 at_place(file, place.line, place.column, escaped(error.description(), 200))};
  }
}

Result<TomlValue> read_toml(const std::filesystem::path& path, std::size_t bytes_max) {
  const auto bytes = read_file(path, bytes_max);
  if (!bytes) return bytes.error();
  return parse_toml(*bytes, path.string());
}

}  // namespace aucast
