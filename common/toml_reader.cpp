#include "common/toml_reader.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"

namespace aucast {
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

std::string unknown_key(std::string_view key, const std::vector<std::string>& known) {
  return "unknown key '" + escaped(key) + "'" + did_you_mean(key, known);
}

}  // namespace

bool TableReader::has(std::string_view key) const {
  return table_.find(key) != nullptr;
}

LinePosition TableReader::place_of(std::string_view key) const {
  const TomlValue* value = table_.find(key);
  return value == nullptr ? table_.place : value->place;
}

const TomlValue* TableReader::value_if(std::string_view key) {
  asked_.emplace_back(key);
  return table_.find(key);
}

const TomlValue* TableReader::needed(std::string_view key, TomlValue::Kind kind) {
  const TomlValue* value = value_if(key);
  if (value == nullptr) {
    if (problems_.none()) missing_ = key;
    problems_.add(table_.place, "'" + std::string(key) + "' is missing");
    return nullptr;
  }
  const bool fits = kind == TomlValue::Kind::Real ? value->is_number() : value->kind == kind;
  if (fits) return value;
  wrong(key, "must be " + std::string(kind_name(kind)));
  return nullptr;
}

void TableReader::wrong(std::string_view key, const std::string& text) {
  problems_.add(place_of(key), std::string(key) + " " + text);
}

double TableReader::checked_number(const TomlValue& value, std::string_view key,
                                   const Bounds& bounds) {
  if (!value.is_number()) {
    problems_.add(value.place, std::string(key) + " must be a number");
  } else if (!std::isfinite(value.real)) {
    problems_.add(value.place, std::string(key) + " is not a finite number");
  } else if (!bounds.contain(value.real)) {
    problems_.add(value.place,
                  std::string(key) + " is " + plain(value.real) + ", must be " + bounds.text());
  } else {
    return value.real;
  }
  return 1;
}

std::string TableReader::text(std::string_view key) {
  const TomlValue* value = needed(key, TomlValue::Kind::Text);
  return value == nullptr ? std::string() : value->text;
}

double TableReader::real(std::string_view key, const Bounds& bounds) {
  const TomlValue* value = needed(key, TomlValue::Kind::Real);
  return value == nullptr ? 1 : checked_number(*value, key, bounds);
}

float TableReader::number(std::string_view key, const Bounds& bounds) {
  return static_cast<float>(real(key, bounds));
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

void TableReader::read_numbers(std::string_view key, std::span<float> values,
                               const Bounds& bounds) {
  std::fill(values.begin(), values.end(), 1.0F);
  const TomlValue* value = needed(key, TomlValue::Kind::Array);
  if (value == nullptr) return;
  if (value->items.size() != values.size()) {
    return wrong(key, "must have " + std::to_string(values.size()) + " numbers");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<float>(checked_number(value->items[i], key, bounds));
  }
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

int TableReader::integer_or(std::string_view key, int fallback, int low, int high) {
  return value_if(key) != nullptr ? integer(key, low, high) : fallback;
}

std::size_t TableReader::word_or(std::string_view key, std::size_t fallback,
                                 std::span<const std::string_view> words) {
  if (value_if(key) == nullptr) return fallback;
  const std::string given = text(key);
  const auto found = std::find(words.begin(), words.end(), given);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string all;
  for (const std::string_view one : words) all += (all.empty() ? "" : ", ") + std::string(one);
  wrong(key, "'" + escaped(given) + "' is not one of " + all);
  return fallback;
}

std::vector<std::string> TableReader::texts(std::string_view key) {
  std::vector<std::string> result;
  if (value_if(key) == nullptr) return result;
  const TomlValue* list = needed(key, TomlValue::Kind::Array);
  if (list == nullptr) return result;
  for (const TomlValue& item : list->items) {
    if (item.kind != TomlValue::Kind::Text) {
      problems_.add(item.place, std::string(key) + " must hold texts");
      return {};
    }
    result.push_back(item.text);
  }
  return result;
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

void TableReader::finish() {
  for (const auto& entry : table_.entries) {
    if (std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end()) continue;
    // A misspelt key says more than the missing one that it stands for.
    if (missing_ && nearest(entry.key, {*missing_})) {
      problems_.replace(entry.place, unknown_key(entry.key, {*missing_}));
      missing_.reset();
    }
    problems_.add(entry.place, unknown_key(entry.key, asked_));
  }
}

}  // namespace aucast
