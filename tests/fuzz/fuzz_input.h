#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace aucast::fuzz {

/// The fuzzer's bytes as text.
[[nodiscard]] inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Takes the input apart as a script: moves of one byte, some followed by a length and bytes.
class Script {
 public:
  explicit Script(std::string_view input) : rest_(input) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }

  /// The next byte; 0 when nothing is left.
  [[nodiscard]] std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const auto value = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }

  /// Everything up to the next line feed, which is dropped. So seeds can be written as lines.
  [[nodiscard]] std::string_view line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return text;
  }

 private:
  std::string_view rest_;
};

/// An input that a target must take whole and in pieces with the same result.
struct PiecedInput {
  std::string_view bytes;
  std::size_t piece = 1;  ///< length of the pieces, 1 to 256
};

/// Takes an input apart: the first byte is the length of the pieces less 1, the rest their bytes.
[[nodiscard]] inline PiecedInput pieced(const std::uint8_t* data, std::size_t size) {
  const std::string_view input = text_of(data, size);
  return {input.substr(std::min<std::size_t>(1, size)), 1U + Script(input).byte()};
}

}  // namespace aucast::fuzz
