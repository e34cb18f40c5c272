#include "client/render/skin_grain.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace aucast::render {
namespace {

constexpr int kGrainSide = 256;
/// Mesh units that one turn of the texture covers: a pore of three texels measures 0.8 mm.
constexpr float kTurn = 5.0F;
constexpr int kPores = 3600;
constexpr float kMoist = 1.45F;  ///< gloss

/// A fixed pseudo-random number in [0, 1).
float hash(std::uint32_t n) {
  n = n * 747796405U + 2891336453U;
  n = ((n >> ((n >> 28U) + 4U)) ^ n) * 277803737U;
  return static_cast<float>((n >> 22U) ^ n) / 4294967296.0F;
}

/// Smooth noise in [0, 1) with features of `cell` texels; it goes on beyond the edges.
float noise(int x, int y, int cell, std::uint32_t seed) {
  const int cells = kGrainSide / cell;
  const auto corner = [&](int i, int j) {
    return hash(seed + static_cast<std::uint32_t>((j % cells) * cells + i % cells));
  };
  const auto eased = [cell](int v) {
    const float t = static_cast<float>(v % cell) / static_cast<float>(cell);
    return t * t * (3 - 2 * t);
  };
  const int i = x / cell;
  const int j = y / cell;
  const float low = std::lerp(corner(i, j), corner(i + 1, j), eased(x));
  const float high = std::lerp(corner(i, j + 1), corner(i + 1, j + 1), eased(x));
  return std::lerp(low, high, eased(y));
}

using Texels = std::vector<std::array<std::uint8_t, 4>>;

/// Colour in the first channel, shine in the second, the slope of the relief across and up in the
/// others; 128 is no change.
Texels texels() {
  std::vector<float> pores(std::size_t{kGrainSide} * kGrainSide, 0.0F);
  for (std::uint32_t n = 0; n < kPores; ++n) {
    const float x = hash(3 * n) * kGrainSide;
    const float y = hash(3 * n + 1) * kGrainSide;
    const float depth = 0.4F + 0.6F * hash(3 * n + 2);
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const int i = static_cast<int>(x) + dx;
        const int j = static_cast<int>(y) + dy;
        const float away = std::hypot(static_cast<float>(i) - x, static_cast<float>(j) - y);
        auto& pore = pores[static_cast<std::size_t>((j & (kGrainSide - 1)) * kGrainSide +
                                                    (i & (kGrainSide - 1)))];
        pore = std::max(pore, depth * std::exp(-away * away));
      }
    }
  }
  std::vector<float> relief(pores.size());
  for (int y = 0; y < kGrainSide; ++y) {
    for (int x = 0; x < kGrainSide; ++x) {
      const auto at = static_cast<std::size_t>(y * kGrainSide + x);
      relief[at] = 0.16F * noise(x, y, 8, 31) + 0.34F * noise(x, y, 4, 407) +
                   0.20F * noise(x, y, 2, 1301) - 0.55F * pores[at];
    }
  }
  const auto height = [&relief](int x, int y) {
    return relief[static_cast<std::size_t>((y & (kGrainSide - 1)) * kGrainSide +
                                           (x & (kGrainSide - 1)))];
  };
  Texels all(pores.size());
  for (int y = 0; y < kGrainSide; ++y) {
    for (int x = 0; x < kGrainSide; ++x) {
      const auto at = static_cast<std::size_t>(y * kGrainSide + x);
      const float blotch =
          0.28F * (noise(x, y, 16, 11) - 0.5F) + 0.22F * (noise(x, y, 8, 977) - 0.5F);
      // Wider than a cheek is lit evenly: without it skin is one paint, and its shine wax.
      const float patch =
          0.32F * (noise(x, y, 64, 71) - 0.5F) + 0.31F * (noise(x, y, 32, 613) - 0.5F);
      const float fine = 0.35F * (noise(x, y, 2, 5003) - 0.5F);
      const auto byte = [](float v) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5F + v, 0.0F, 1.0F)));
      };
      all[at] = {byte(blotch + patch + fine - 0.35F * pores[at] + 0.05F),
                 byte(0.5F * blotch + 0.8F * patch + 1.4F * fine - 0.8F * pores[at] + 0.12F),
                 byte(height(x - 1, y) - height(x + 1, y)),
                 byte(height(x, y - 1) - height(x, y + 1))};
    }
  }
  return all;
}

}  // namespace

SkinGrain::SkinGrain() {
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  const Texels all = texels();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kGrainSide, kGrainSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               all.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

std::vector<glm::vec2> SkinGrain::places(std::span<const glm::vec3> rest,
                                         std::span<const float> gloss) {
  std::vector<glm::vec2> places;
  places.reserve(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const glm::vec3& p = rest[i];
    // Round an axis through the middle of the head, and slanting, so that what faces down or aside
    // is not drawn out. The neck is thinner. The sides are not quite mirror images.
    const float radius = std::clamp(std::hypot(p.x, p.z - 1.5F), 2.0F, 5.0F);
    const float angle = std::abs(std::atan2(p.x, p.z - 1.5F));
    const float round = radius * angle * (p.x < 0 ? 1.13F : 1.0F) - 0.35F * p.z;
    const glm::vec2 place{round, p.y - 0.35F * p.z + 0.25F * std::abs(p.x)};
    // Lips, which are moister than skin, have fine upright lines.
    const glm::vec2 drawn_out = gloss[i] > kMoist && p.y < 0 ? glm::vec2{2.6F, 0.7F} : glm::vec2{1};
    places.push_back(place * drawn_out / kTurn);
  }
  return places;
}

void SkinGrain::bind(GLenum unit) const {
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, texture_.id());
}

}  // namespace aucast::render
