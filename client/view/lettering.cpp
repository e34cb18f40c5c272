#include "client/view/lettering.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Of this file alone: ImGui takes the same functions from libstb, where they go with another
// stb_rect_pack.
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

#include "common/check.h"
#include "common/embedded_file.h"

namespace aucast::view {
namespace {

const stbtt_fontinfo& font() {
  static const stbtt_fontinfo font = [] {
    stbtt_fontinfo read;
    const auto* const bytes =
        reinterpret_cast<const unsigned char*>(embedded::fonts().front().bytes.data());
    AUCAST_CHECK(stbtt_InitFont(&read, bytes, 0) != 0);
    return read;
  }();
  return font;
}

/// How many pixels one unit of the font is.
float scale_of(int cap_height) {
  int top = 0;
  stbtt_GetCodepointBox(&font(), 'H', nullptr, nullptr, nullptr, &top);
  return static_cast<float>(cap_height) / static_cast<float>(top);
}

int printable(char character) {
  return character >= ' ' && character <= '~' ? character : '?';
}

float advance_of(char character, float scale) {
  int advance = 0;
  stbtt_GetCodepointHMetrics(&font(), printable(character), &advance, nullptr);
  return scale * static_cast<float>(advance);
}

void blend(Image& image, int x, int y, std::uint32_t rgb, int cover) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(x));
  for (std::size_t c = 0; c < 3; ++c) {
    const int ink = static_cast<int>((rgb >> (16U - 8U * c)) & 255U);
    const int ground = image.rgba[at + c];
    image.rgba[at + c] =
        static_cast<std::uint8_t>((ink * cover + ground * (255 - cover) + 127) / 255);
  }
}

}  // namespace

int text_width(std::string_view text, int cap_height) {
  const float scale = scale_of(cap_height);
  float width = 0;
  for (const char character : text) width += advance_of(character, scale);
  return static_cast<int>(std::ceil(width));
}

void draw_text(Image& image, int x, int y, std::string_view text, int cap_height,
               std::uint32_t rgb) {
  const float scale = scale_of(cap_height);
  float left = static_cast<float>(x);
  std::vector<unsigned char> cover;
  for (const char character : text) {
    const float whole = std::floor(left);
    const float shift = left - whole;
    std::array<int, 4> box{};  // from the pen on the line
    stbtt_GetCodepointBitmapBoxSubpixel(&font(), printable(character), scale, scale, shift, 0,
                                        &box[0], &box[1], &box[2], &box[3]);
    const int width = box[2] - box[0];
    const int height = box[3] - box[1];
    cover.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    stbtt_MakeCodepointBitmapSubpixel(&font(), cover.data(), width, height, width, scale, scale,
                                      shift, 0, printable(character));
    for (int i = 0; i < width * height; ++i) {
      blend(image, static_cast<int>(whole) + box[0] + i % width,
            y + cap_height + box[1] + i / width, rgb, cover[static_cast<std::size_t>(i)]);
    }
    left += advance_of(character, scale);
  }
}

}  // namespace aucast::view
