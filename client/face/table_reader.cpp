#include "client/face/table_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "common/text.h"

namespace aucast::face {
namespace {

std::string_view kind_name(TomlValue::Kind kind) {
  switch (kind) {
    case TomlValue::Kind::Boolean:
      return "true or false";
    case TomlValue::Kind::Integer:
      return "a whole number";
    case TomlValue::Kind::Real:
      return "a number";
    case TomlValue::Kind::Text:
      return "a text";
    case TomlValue::Kind::Array:
      return "a list";
    case TomlValue::Kind::Table:
      return "a table";
    case TomlValue::Kind::Other:
      break;
  }
  return "a value";
}

bool is_number(const TomlValue& value) {
  return value.kind == TomlValue::Kind::Integer || value.kind == TomlValue::Kind::Real;
}

}  // namespace

void Problems::add(Place place, const std::string& text) {
  if (first_) return;
  first_ = Error{ErrorKind::BadData, at_place(file_, place.line, place.column, text)};
}

Result<void> Problems::result() const {
  if (first_) return *first_;
  return {};
}

bool Bounds::contain(double value) const {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::string Bounds::text() const {
  constexpr double kNoLimit = 1e6;
  const std::string from = (low_open ? "above " : "from ") + plain(low);
  if (high >= kNoLimit && low > -kNoLimit) return low_open ? from : "at least " + plain(low);
  return from + (high_open ? " and below " : " to ") + plain(high);
}

bool TableReader::has(std::string_view key) const {
  return std::any_of(table_.entries.begin(), table_.entries.end(),
                     [key](const auto& entry) { return entry.key == key; });
}

Place TableReader::place_of(std::string_view key) const {
  for (const auto& entry : table_.entries) {
    if (entry.key == key) return entry.value.place;
  }
  return table_.place;
}

const TomlValue* TableReader::find(std::string_view key) {
  asked_.emplace_back(key);
  for (const auto& entry : table_.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

const TomlValue* TableReader::needed(std::string_view key, TomlValue::Kind kind) {
  const TomlValue* value = find(key);
  if (value == nullptr) {
    // A misspelt key says more than a missing one.
    for (const auto& entry : table_.entries) {
      if (nearest(entry.key, {std::string(key)})) return unknown(entry), nullptr;
    }
    problems_.add(table_.place, "'" + std::string(key) + "' is missing");
    return nullptr;
  }
  const bool fits = kind == TomlValue::Kind::Real ? is_number(*value) : value->kind == kind;
  if (fits) return value;
  wrong(key, "must be " + std::string(kind_name(kind)));
  return nullptr;
}

void TableReader::wrong(std::string_view key, const std::string& text) {
  problems_.add(place_of(key), std::string(key) + " " + text);
}

float TableReader::checked_number(const TomlValue& value, std::string_view key,
                                  const Bounds& bounds) {
  if (!is_number(value)) {
    problems_.add(value.place, std::string(key) + " must be a number");
  } else if (!std::isfinite(value.real)) {
    problems_.add(value.place, std::string(key) + " is not a finite number");
  } else if (!bounds.contain(value.real)) {
    problems_.add(value.place,
                  std::string(key) + " is " + plain(value.real) + ", must be " + bounds.text());
  } else {
    return static_cast<float>(value.real);
  }
  return 1;
}

std::string TableReader::text(std::string_view key) {
  const TomlValue* value = needed(key, TomlValue::Kind::Text);
  return value == nullptr ? std::string() : value->text;
}

float TableReader::number(std::string_view key, const Bounds& bounds) {
  const TomlValue* value = needed(key, TomlValue::Kind::Real);
  return value == nullptr ? 1 : checked_number(*value, key, bounds);
}

int TableReader::integer(std::string_view key, int low, int high) {
  const TomlValue* value = needed(key, TomlValue::Kind::Integer);
  if (value == nullptr) return low;
  if (value->integer < low || value->integer > high) {
    wrong(key, "is " + std::to_string(value->integer) + ", must be " +
                   Bounds::between(low, high).text());
    return low;
  }
  return static_cast<int>(value->integer);
}

std::vector<float> TableReader::numbers(std::string_view key, std::size_t count,
                                        const Bounds& bounds) {
  std::vector<float> result(count, 1.0F);
  const TomlValue* value = needed(key, TomlValue::Kind::Array);
  if (value == nullptr) return result;
  if (value->items.size() != count) {
    wrong(key, "must have " + std::to_string(count) + " numbers");
    return result;
  }
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = checked_number(value->items[i], key, bounds);
  }
  return result;
}

glm::vec3 TableReader::point(std::string_view key, const Bounds& bounds) {
  const std::vector<float> values = numbers(key, 3, bounds);
  return {values[0], values[1], values[2]};
}

glm::vec2 TableReader::pair(std::string_view key, const Bounds& bounds) {
  const std::vector<float> values = numbers(key, 2, bounds);
  return {values[0], values[1]};
}

std::vector<int> TableReader::integers(std::string_view key, int low, int high) {
  std::vector<int> result;
  const TomlValue* value = needed(key, TomlValue::Kind::Array);
  if (value == nullptr) return result;
  for (const TomlValue& item : value->items) {
    if (item.kind != TomlValue::Kind::Integer || item.integer < low || item.integer > high) {
      problems_.add(item.place, std::string(key) + " must hold whole numbers " +
                                    Bounds::between(low, high).text());
      return result;
    }
    result.push_back(static_cast<int>(item.integer));
  }
  if (result.empty()) wrong(key, "must not be empty");
  return result;
}

std::string TableReader::text_or(std::string_view key, std::string_view fallback) {
  return value_if(key) != nullptr ? text(key) : std::string(fallback);
}

float TableReader::number_or(std::string_view key, float fallback, const Bounds& bounds) {
  return value_if(key) != nullptr ? number(key, bounds) : fallback;
}

bool TableReader::boolean_or(std::string_view key, bool fallback) {
  if (value_if(key) == nullptr) return fallback;
  const TomlValue* value = needed(key, TomlValue::Kind::Boolean);
  return value != nullptr && value->boolean;
}

const TomlValue* TableReader::table_if(std::string_view key) {
  return value_if(key) != nullptr ? needed(key, TomlValue::Kind::Table) : nullptr;
}

std::vector<const TomlValue*> TableReader::tables(std::string_view key) {
  std::vector<const TomlValue*> result;
  const TomlValue* value = value_if(key);
  if (value == nullptr) return result;
  if (value->kind != TomlValue::Kind::Array) {
    wrong(key, "must be written [[" + std::string(key) + "]]");
    return result;
  }
  for (const TomlValue& item : value->items) {
    if (item.kind != TomlValue::Kind::Table) {
      problems_.add(item.place, std::string(key) + " must hold tables");
      return {};
    }
    result.push_back(&item);
  }
  return result;
}

const TomlValue* TableReader::value_if(std::string_view key) {
  return find(key);
}

void TableReader::finish() {
  for (const auto& entry : table_.entries) {
    if (std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end()) continue;
    unknown(entry);
  }
}

void TableReader::unknown(const TomlValue::Entry& entry) {
  problems_.add(entry.place,
                "unknown key '" + escaped(entry.key) + "'" + did_you_mean(entry.key, asked_));
}

std::string plain(double value) {
  std::array<char, 32> digits{};
  const auto [end, code] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                         std::chars_format::general, 6);
  return code == std::errc() ? std::string(digits.data(), end) : std::string("?");
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const auto near = nearest(word, known);
  return near ? "; did you mean " + *near + "?" : std::string();
}

}  // namespace aucast::face
