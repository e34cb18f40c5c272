#include "common/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <system_error>

#include "common/check.h"

namespace aucast {
namespace {

/// How many letters are added, left out, replaced or swapped with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);  // rows of the table, for the beginnings of `a`
  std::vector<std::size_t> above = before;
  std::vector<std::size_t> row = before;
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, above);
    std::swap(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string hex_escape(char byte) {
  constexpr std::string_view kHex = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(byte);
  return {'\\', 'x', kHex[code >> 4U], kHex[code & 15U]};
}

}  // namespace

std::string escaped(std::string_view bytes, std::size_t length_max) {
  std::string text;
  for (const char byte : bytes) {
    if (text.size() >= length_max) return text + "...";
    const auto code = static_cast<unsigned char>(byte);
    if (code >= 0x20 && code < 0x7f && byte != '\\') {
      text += byte;
    } else {
      text += hex_escape(byte);
    }
  }
  return text;
}

std::size_t utf8_length(std::string_view bytes) {
  const auto byte = [&bytes](std::size_t i) -> std::uint32_t {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
  };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return bytes.empty() ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  constexpr std::array<std::uint32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  std::uint32_t code = first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return 0;
    code = code << 6U | (byte(i) & 0x3fU);
  }
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  const bool valid =
      first >= 0xc0 && first < 0xf8 && code >= kSmallest[length] && code < 0x110000 && !surrogate;
  return valid ? length : 0;
}

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  return first < 0x20 || first == 0x7f ||
         (first == 0xc2 && character.size() == 2 &&
          static_cast<unsigned char>(character[1]) < 0xa0);
}

std::string printable(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(bytes), 1);
    const bool plain = utf8_length(bytes) != 0 && !is_control(bytes.substr(0, length));
    for (const char byte : bytes.substr(0, length))
      text += plain ? std::string(1, byte) : hex_escape(byte);
    bytes.remove_prefix(length);
  }
  return text;
}

std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& known) {
  std::optional<std::string> best;
  // Of a short word half the letters at most, without its dashes: -o is no typo of -v.
  const std::size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  std::size_t best_distance = std::min(std::max<std::size_t>(2, word.size() / 3), letters / 2) + 1;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const auto near = nearest(word, known);
  return near ? "; did you mean " + printable(*near) + "?" : std::string();
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> split_words(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<std::string_view> found;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (text.empty()) return found;
    const std::size_t length = std::min(text.find_first_of(kBlanks), text.size());
    found.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
}

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string file_ending(const std::filesystem::path& file) {
  return lowered(file.extension().string());
}

std::string counted(std::uint64_t count, std::string_view thing) {
  return std::to_string(count) + " " + std::string(thing) + (count == 1 ? "" : "s");
}

std::string length_text(Milliseconds length) {
  const bool any = length > Milliseconds::zero();
  const auto whole = std::max<std::int64_t>((length.count() + 500) / 1000, any ? 1 : 0);
  const auto two_digits = [](std::int64_t value) {
    return (value < 10 ? "0" : "") + std::to_string(value);
  };
  const std::int64_t minutes = whole / 60;
  const std::string end = ":" + two_digits(whole % 60);
  if (minutes < 60) return std::to_string(minutes) + end;
  return std::to_string(minutes / 60) + ":" + two_digits(minutes % 60) + end;
}

std::string number_text(double value) {
  std::array<char, 32> digits{};
#if defined(__cpp_lib_to_chars)
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  AUCAST_CHECK(error == std::errc());
  return {digits.data(), end};
#else
  // emscripten's library writes no floating point with to_chars.
  int length = 0;
  for (int precision = 1; precision <= 17; ++precision) {
    length = std::snprintf(digits.data(), digits.size(), "%.*g", precision, value);
    if (std::strtod(digits.data(), nullptr) == value) break;
  }
  return {digits.data(), static_cast<std::size_t>(length)};
#endif
}

std::string system_reason(int error_number) {
  return std::generic_category().message(error_number);
}

std::string shortage_text(const std::system_error& failure) {
  return failure.code().message() + "; the system is short of threads or files";
}

std::string at_place(std::string_view file, std::size_t line, std::size_t column,
                     std::string_view text) {
  std::string place = printable(file);
  if (line != 0) place += ":" + std::to_string(line);
  if (line != 0 && column != 0) place += ":" + std::to_string(column);
  return place + ": " + std::string(text);
}

std::string at_place(std::string_view file, std::string_view text) {
  return at_place(file, 0, 0, text);
}

}  // namespace aucast
