#include "common/toml_writer.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "common/text.h"

namespace aucast {

std::string toml_text(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string quoted = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto code = static_cast<unsigned char>(text.front());
    if (length == 0) {
      quoted += "\xef\xbf\xbd";
    } else if (code == '"' || code == '\\') {
      quoted += {'\\', text.front()};
    } else if (code < 0x20 || code == 0x7f) {
      quoted += {'\\', 'u', '0', '0', kHex[code >> 4U], kHex[code & 15U]};
    } else {
      quoted += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return quoted + '"';
}

std::string toml_texts(std::span<const std::string> texts) {
  std::string list = "[";
  for (const std::string& text : texts) list += (list.size() > 1 ? ", " : "") + toml_text(text);
  return list + "]";
}

std::string toml_real(float value) {
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  std::string text(digits.data(), written.ptr);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string toml_key(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  return bare ? std::string(key) : toml_text(key);
}

std::string toml_line(std::string_view key, std::string_view value) {
  return toml_key(key) + " = " + std::string(value) + "\n";
}

}  // namespace aucast
