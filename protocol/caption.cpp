#include "protocol/caption.h"

#include <utility>

#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/limits.h"
#include "protocol/placed_data.h"

namespace aucast::protocol {
namespace {

bool is_text(std::string_view text, bool line_feeds) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    const bool line_feed = line_feeds && text.front() == '\n';
    if (!line_feed && is_control(text.substr(0, length))) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

bool is_caption(std::string_view text) {
  // Braces, the word, the longest place and a space.
  constexpr std::size_t kAround = 18;
  constexpr std::size_t kTextMax = (kCaptionBytesMax - kAround) / 4 * 3;
  return text.size() <= kTextMax && is_text(text, true);
}

bool is_title(std::string_view text) {
  return text.size() <= kTitleBytesMax && is_text(text, false);
}

std::variant<CaptionData, FieldFault> parse_caption(std::string_view text) {
  auto fields = parse_placed_data(text);
  if (auto* fault = std::get_if<FieldFault>(&fields)) return std::move(*fault);
  auto& [place_ms, bytes, position] = std::get<PlacedData>(fields);
  if (!place_ms) return FieldFault{position, "a caption has a place: {t@PLACE DATA}"};
  if (!is_text(bytes, true)) {
    return FieldFault{position, "a caption is UTF-8 without control characters"};
  }
  return CaptionData{*place_ms, std::move(bytes)};
}

std::string encode(const CaptionData& caption) {
  return encode_placed_data('t', caption.place_ms, caption.text);
}

}  // namespace aucast::protocol
