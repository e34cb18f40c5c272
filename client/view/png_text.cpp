#include "client/view/png_text.h"

#include <optional>

#include "common/check.h"

namespace aucast::view {
namespace {

/// Signature (8), then length (4), type (4), header (13) and check sum (4) of the first chunk.
constexpr std::size_t kHeaderEnd = 8 + 4 + 4 + 13 + 4;
constexpr std::size_t kKeywordMax = 79;

void append_big_endian(std::string& bytes, std::uint32_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift));
  }
}

/// UTF-8 as Latin-1; nullopt: a character is not in it, or is a control character other than the
/// end of a line.
std::optional<std::string> in_latin_1(std::string_view utf8) {
  std::string text;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte == '\n' || (byte >= 0x20 && byte < 0x7F)) {
      text += utf8[i];
      continue;
    }
    // U+00A0 to U+00FF are C2 or C3 and one more byte.
    if ((byte != 0xC2 && byte != 0xC3) || i + 1 == utf8.size()) return std::nullopt;
    const auto next = static_cast<unsigned char>(utf8[++i]);
    const bool printed = next >= (byte == 0xC2 ? 0xA0 : 0x80) && next <= 0xBF;
    if (!printed) return std::nullopt;
    text += static_cast<char>(byte == 0xC2 ? next : next + 0x40U);
  }
  return text;
}

std::string chunk(const PngText& text) {
  AUCAST_CHECK(!text.keyword.empty() && text.keyword.size() <= kKeywordMax);
  using std::string_literals::operator""s;
  const auto latin_1 = in_latin_1(text.text);
  // Of iTXt: not compressed, no language, the keyword not translated.
  const std::string typed = latin_1 ? "tEXt" + text.keyword + "\0"s + *latin_1
                                    : "iTXt" + text.keyword + "\0\0\0\0\0"s + text.text;
  std::string bytes;
  append_big_endian(bytes, static_cast<std::uint32_t>(typed.size() - 4));
  bytes += typed;
  append_big_endian(bytes, crc32(typed));
  return bytes;
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;  // reversed
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? kPolynomial : 0U);
  }
  return ~sum;
}

std::string with_texts(std::string_view png, std::span<const PngText> texts) {
  AUCAST_CHECK(png.size() > kHeaderEnd);
  std::string bytes(png.substr(0, kHeaderEnd));
  for (const PngText& text : texts) bytes += chunk(text);
  return bytes.append(png.substr(kHeaderEnd));
}

}  // namespace aucast::view
