#include "client/view/png_text.h"

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

std::string chunk(const PngText& text) {
  AUCAST_CHECK(!text.keyword.empty() && text.keyword.size() <= kKeywordMax);
  using std::string_literals::operator""s;
  // Not compressed, no language, the keyword not translated.
  const std::string typed = "iTXt" + text.keyword + "\0\0\0\0\0"s + text.text;
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
