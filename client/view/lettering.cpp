#include "client/view/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace aucast::view {
namespace {

/// A stroke font of our own for the printable characters from blank to tilde, so that pictures need
/// no font file. A glyph is its advance, then strokes; a stroke is points of two hexadecimal
/// digits, x and y, on a grid whose y is 0 at the top of capitals, 4 at the top of small letters, c
/// on the line and f below it. A tilde in front of a stroke rounds its corners.
constexpr std::array<std::string_view, 95> kGlyphs{
    "5",
    "3 1018 1b1c",
    "5 1013 3033",
    "9 302c 605c 0484 0888",
    "8 ~72701016767c1c1a 4e4c 4042",
    "9 800c ~0030340400 ~58888c5c58",
    "9 ~7c14105054080c5c87",
    "3 1013",
    "4 ~3013193d",
    "4 ~1033391d",
    "6 3137 1256 5216",
    "8 434b 0777",
    "3 1b0e",
    "6 1757",
    "3 1b1c",
    "6 500d",
    "8 ~10707c1c10",
    "8 22505c",
    "8 ~131070741c 1c7c",
    "8 ~1210707636 ~36767c1c1a",
    "8 5c500979",
    "8 702015 ~15757c1c1a",
    "8 ~7270101c7c7616",
    "8 10703c",
    "8 ~1070761610 ~16767c1c16",
    "8 ~1a1c7c70101676",
    "3 1516 1b1c",
    "3 1516 1b0e",
    "7 63176b",
    "8 1575 1979",
    "7 13671b",
    "7 ~1210606538 3b3c",
    "b ~4474794944 ~7479a9a0101c8c",
    "8 0c408c 2868",
    "8 101c ~10606616 ~16777c1c",
    "8 ~7370101c7c79",
    "8 101c ~10707c1c",
    "7 60101c6c 1656",
    "7 60101c 1656",
    "8 ~7370101c7c77 7747",
    "8 101c 707c 1676",
    "3 101c",
    "6 ~505c0c09",
    "8 101c 7018 367c",
    "7 101c6c",
    "a 1c1058909c",
    "8 1c107c70",
    "9 ~10808c1c10",
    "8 101c ~10707717",
    "9 ~10808c1c10 598d",
    "8 101c ~10707717 477c",
    "8 ~72701016767c1c1a",
    "8 0080 404c",
    "8 ~101c7c70",
    "8 004c80",
    "a 003c528ca0",
    "8 007c 700c",
    "8 004680 464c",
    "8 10701c7c",
    "4 30101d3d",
    "6 005d",
    "4 10303d1d",
    "7 143064",
    "7 0d6d",
    "4 1022",
    "7 646c ~64141c6c64",
    "7 101c ~14646c1c14",
    "7 ~6664141c6c6a",
    "7 606c ~64141c6c64",
    "7 1868 ~6864141c6c6a",
    "5 ~502024 242c 0454",
    "7 ~64141c6c64 ~646f1f",
    "7 101c ~14646c",
    "3 141c 1011",
    "4 ~242f0f 2021",
    "6 101c 6419 286c",
    "4 ~101c3c",
    "a 141c ~14545c ~54949c",
    "7 141c ~14646c",
    "7 ~14646c1c14",
    "7 141f ~14646c1c14",
    "7 646f ~64141c6c64",
    "5 141c ~181454",
    "7 ~66641418686c1c1a",
    "5 ~212c5c 0454",
    "7 ~141c6c64 646c",
    "7 043c64",
    "9 042c456c84",
    "7 046c 640c",
    "7 043c 641f",
    "7 14640c6c",
    "5 ~40202606 ~06262d4d",
    "3 101e",
    "5 ~00202646 ~46262d0d",
    "8 ~18256976",
};

constexpr float kGridCapHeight = 12.0F;
constexpr float kGridSpacing = 1.6F;
constexpr int kRoundings = 3;
/// Line width by cap height: a book weight that stays legible at 9 pixels.
constexpr float kLineWidth = 0.125F;

using Stroke = std::vector<glm::vec2>;

float hex_digit(char digit) {
  return static_cast<float>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
}

/// Chaikin's corner cutting (1974): each corner is replaced by the quarter points beside it.
Stroke rounded(const Stroke& stroke) {
  const bool closed = stroke.front() == stroke.back();
  Stroke result;
  if (!closed) result.push_back(stroke.front());
  for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
    result.push_back(stroke[i] * 0.75F + stroke[i + 1] * 0.25F);
    result.push_back(stroke[i] * 0.25F + stroke[i + 1] * 0.75F);
  }
  result.push_back(closed ? result.front() : stroke.back());
  return result;
}

std::string_view glyph_of(char character) {
  const auto code = static_cast<unsigned char>(character);
  const bool known = code >= ' ' && code <= '~';
  return kGlyphs[known ? code - std::size_t{' '} : std::size_t{'?' - ' '}];
}

float advance_of(std::string_view glyph) {
  return hex_digit(glyph.front()) + kGridSpacing;
}

std::vector<Stroke> strokes_of(std::string_view glyph) {
  std::vector<Stroke> strokes;
  bool round = false;
  for (std::size_t i = 1; i < glyph.size();) {
    if (glyph[i] == ' ') {
      strokes.emplace_back();
      round = glyph[i + 1] == '~';
      i += round ? 2 : 1;
      continue;
    }
    strokes.back().emplace_back(hex_digit(glyph[i]), hex_digit(glyph[i + 1]));
    i += 2;
    const bool ends = i >= glyph.size() || glyph[i] == ' ';
    for (int k = 0; ends && round && k < kRoundings; ++k) strokes.back() = rounded(strokes.back());
  }
  return strokes;
}

float distance_to_segment(glm::vec2 point, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 along = b - a;
  const float length_squared = glm::dot(along, along);
  const float t =
      length_squared > 0 ? std::clamp(glm::dot(point - a, along) / length_squared, 0.0F, 1.0F) : 0;
  return glm::length(point - a - along * t);
}

float distance_to(const std::vector<Stroke>& strokes, glm::vec2 point) {
  float nearest = 1e9F;
  for (const Stroke& stroke : strokes) {
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
      nearest = std::min(nearest, distance_to_segment(point, stroke[i], stroke[i + 1]));
    }
  }
  return nearest;
}

void blend(Image& image, int x, int y, std::uint32_t rgb, float cover) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height || cover <= 0) return;
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(x));
  for (std::size_t c = 0; c < 3; ++c) {
    const auto ink = static_cast<float>((rgb >> (16U - 8U * c)) & 255U);
    const auto ground = static_cast<float>(image.rgba[at + c]);
    image.rgba[at + c] = static_cast<std::uint8_t>(std::lround(ground + (ink - ground) * cover));
  }
}

}  // namespace

int text_width(std::string_view text, int cap_height) {
  float width = 0;
  for (const char character : text) width += advance_of(glyph_of(character));
  return static_cast<int>(std::ceil(width * static_cast<float>(cap_height) / kGridCapHeight));
}

void draw_text(Image& image, int x, int y, std::string_view text, int cap_height,
               std::uint32_t rgb) {
  const float scale = static_cast<float>(cap_height) / kGridCapHeight;
  const float half_line = std::max(0.5F, 0.5F * kLineWidth * static_cast<float>(cap_height));
  const int below = static_cast<int>(std::ceil(17.0F * scale));
  float left = static_cast<float>(x);
  for (const char character : text) {
    const std::string_view glyph = glyph_of(character);
    std::vector<Stroke> strokes = strokes_of(glyph);
    for (Stroke& stroke : strokes) {
      for (glm::vec2& point : stroke) {
        point = point * scale + glm::vec2(left, static_cast<float>(y));
      }
    }
    const float right = left + advance_of(glyph) * scale;
    for (int row = y - 2; row < y + below; ++row) {
      for (int column = static_cast<int>(left) - 2; column < static_cast<int>(right) + 2;
           ++column) {
        const glm::vec2 centre(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
        const float cover = half_line + 0.5F - distance_to(strokes, centre);
        blend(image, column, row, rgb, std::clamp(cover, 0.0F, 1.0F));
      }
    }
    left = right;
  }
}

}  // namespace aucast::view
