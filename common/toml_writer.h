#pragma once

#include <span>
#include <string>
#include <string_view>

namespace aucast {

// Parts of a TOML file as text, which parse_toml() reads back as the same values.

/// A string in quotes. TOML is UTF-8: bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string toml_text(std::string_view text);
/// ["a", "b"]
[[nodiscard]] std::string toml_texts(std::span<const std::string> texts);
/// The shortest form of a real number; 1.0 for 1.
[[nodiscard]] std::string toml_real(float value);
/// A key, in quotes where it needs them.
[[nodiscard]] std::string toml_key(std::string_view key);
/// "key = value\n"
[[nodiscard]] std::string toml_line(std::string_view key, std::string_view value);

}  // namespace aucast
