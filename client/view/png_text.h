#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace aucast::view {

/// A fact about a picture, stored in its PNG as text.
struct PngText {
  std::string keyword;  ///< 1-79 characters of Latin-1, such as "Software"
  std::string text;     ///< UTF-8
};

/// The PNG with these texts in front of its pixels. Each becomes a tEXt chunk, which every program
/// shows, or an iTXt chunk if Latin-1 lacks one of its letters (PNG, third edition, 11.3.3.2 and
/// 11.3.3.4). `png` must begin with the signature and the header, as every PNG does.
[[nodiscard]] std::string with_texts(std::string_view png, std::span<const PngText> texts);

/// The check sum of PNG's chunks: CRC-32 of ISO 3309 (PNG, third edition, annex D).
[[nodiscard]] std::uint32_t crc32(std::string_view bytes);

}  // namespace aucast::view
