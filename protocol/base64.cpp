#include "protocol/base64.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/text.h"

namespace aucast::protocol {
namespace {

constexpr std::string_view kAlphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 64;

constexpr std::array<std::uint8_t, 256> digit_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoDigit);
  for (std::size_t at = 0; at < kAlphabet.size(); ++at) {
    values[static_cast<std::uint8_t>(kAlphabet[at])] = static_cast<std::uint8_t>(at);
  }
  return values;
}

constexpr std::array<std::uint8_t, 256> kDigitValue = digit_values();

}  // namespace

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() * 4 + 2) / 3);
  std::uint32_t pending = 0;
  unsigned bits = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    pending = pending << 8U | byte_at(bytes, at);
    for (bits += 8; bits >= 6; bits -= 6) text += kAlphabet[pending >> (bits - 6) & 63U];
  }
  if (bits > 0) text += kAlphabet[pending << (6 - bits) & 63U];
  return text;
}

std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() * 3 / 4);
  std::uint32_t pending = 0;
  unsigned bits = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::uint8_t value = kDigitValue[byte_at(text, at)];
    if (value == kNoDigit) return std::nullopt;
    pending = pending << 6U | value;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(pending >> bits & 0xFFU);
  }
  const bool digits_make_bytes = text.size() % 4 != 1;
  const bool rest_is_zero = (pending & ((1U << bits) - 1U)) == 0;
  if (!digits_make_bytes || !rest_is_zero) return std::nullopt;
  return bytes;
}

}  // namespace aucast::protocol
