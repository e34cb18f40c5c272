#include "common/mesh/picture.h"

#include <cmath>

namespace aucast::mesh {
namespace {

constexpr double kPixelsMax = 1e6;

/// A pixel's three bytes; black outside of the picture.
const std::uint8_t* pixel_at(const Picture& picture, std::int64_t x, std::int64_t y) {
  static constexpr std::uint8_t kBlack[3] = {0, 0, 0};
  const bool inside = x >= 0 && y >= 0 && x < static_cast<std::int64_t>(picture.width) &&
                      y < static_cast<std::int64_t>(picture.height);
  if (!inside) return kBlack;
  const std::size_t row = static_cast<std::size_t>(y) * picture.width;
  return picture.rgb.data() + 3 * (row + static_cast<std::size_t>(x));
}

}  // namespace

bool can_be_seen(const Square& square) {
  return std::isfinite(square.turn_rad) && std::abs(square.x) < kPixelsMax &&
         std::abs(square.y) < kPixelsMax && square.side >= 1 && square.side < kPixelsMax;
}

bool show_the_same(const Square& one, const Square& other) {
  constexpr double kApartMax = 0.4;  // of the smaller side
  const double apart = std::hypot(one.x - other.x, one.y - other.y);
  return apart < kApartMax * std::min(one.side, other.side);
}

void sample_square(const Picture& picture, const Square& square, std::size_t size, float low,
                   float high, std::span<float> out) {
  const double step = square.side / static_cast<double>(size);
  const double cosine = std::cos(square.turn_rad) * step;
  const double sine = std::sin(square.turn_rad) * step;
  const double middle = static_cast<double>(size) / 2 - 0.5;
  const float scale = (high - low) / 255.0F;
  float* to = out.data();
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column, to += 3) {
      const double u = static_cast<double>(column) - middle;
      const double v = static_cast<double>(row) - middle;
      const double x = square.x + cosine * u - sine * v - 0.5;
      const double y = square.y + sine * u + cosine * v - 0.5;
      const double left = std::floor(x);
      const double top = std::floor(y);
      const auto to_right = static_cast<float>(x - left);
      const auto to_below = static_cast<float>(y - top);
      const auto ix = static_cast<std::int64_t>(left);
      const auto iy = static_cast<std::int64_t>(top);
      const std::uint8_t* a = pixel_at(picture, ix, iy);
      const std::uint8_t* b = pixel_at(picture, ix + 1, iy);
      const std::uint8_t* c = pixel_at(picture, ix, iy + 1);
      const std::uint8_t* d = pixel_at(picture, ix + 1, iy + 1);
      for (std::size_t colour = 0; colour < 3; ++colour) {
        const auto number = [colour](const std::uint8_t* pixel) {
          return static_cast<float>(pixel[colour]);
        };
        const float upper = number(a) * (1 - to_right) + number(b) * to_right;
        const float lower = number(c) * (1 - to_right) + number(d) * to_right;
        to[colour] = low + scale * (upper * (1 - to_below) + lower * to_below);
      }
    }
  }
}

}  // namespace aucast::mesh
