#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/result.h"

namespace aucast {

/// Line and column in a file, both from 1.
struct Place {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// A value of a TOML file and where it stands. A tree of our own, so that one source only includes
/// the TOML library. Which members are used depends on the kind; Other is what we never read (dates
/// and times).
struct TomlValue {
  enum class Kind : std::uint8_t { Boolean, Integer, Real, Text, Array, Table, Other };

  struct Entry;

  Kind kind = Kind::Other;
  Place place;
  bool boolean = false;
  std::int64_t integer = 0;
  double real = 0;  ///< for an integer too
  std::string text;
  std::vector<TomlValue> items;  ///< of an array
  std::vector<Entry> entries;    ///< of a table, in the order of the file
};

struct TomlValue::Entry {
  std::string key;
  Place place;  ///< of the key
  TomlValue value;
};

/// The file's table. BadData "file:line:column: ..." when it is no TOML.
[[nodiscard]] Result<TomlValue> parse_toml(std::string_view bytes, std::string_view file);

}  // namespace aucast
