#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/problems.h"
#include "common/result.h"

namespace aucast {

/// A value of a TOML file and its position. A tree of our own, so that only toml_document.cpp
/// includes the TOML library. The kind says which members are set; Other is a date or a time.
struct TomlValue {
  enum class Kind : std::uint8_t { Boolean, Integer, Real, Text, Array, Table, Other };

  struct Entry;

  Kind kind = Kind::Other;
  LinePosition place;
  bool boolean = false;
  std::int64_t integer = 0;
  double real = 0;  ///< for an integer too
  std::string text;
  std::vector<TomlValue> items;  ///< of an array
  std::vector<Entry> entries;    ///< of a table, in the order of the file

  [[nodiscard]] bool is_number() const { return kind == Kind::Integer || kind == Kind::Real; }
  /// The value of a table's key; null when it has no such key, or this is no table.
  [[nodiscard]] const TomlValue* find(std::string_view key) const;
};

struct TomlValue::Entry {
  std::string key;
  LinePosition place;  ///< of the key
  TomlValue value;
};

/// The table of a whole file. Fails with BadData, "file:line:column: ...", if the text is not TOML.
[[nodiscard]] Result<TomlValue> parse_toml(std::string_view bytes, std::string_view file);

/// read_file(), then parse_toml().
[[nodiscard]] Result<TomlValue> read_toml(const std::filesystem::path& path,
                                          std::size_t bytes_max = std::size_t{4} << 20U);

}  // namespace aucast
