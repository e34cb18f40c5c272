#include "client/glb/strand_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/srgb.h"

namespace aucast::glb {
namespace {

constexpr int kStrandsRound = 900;  ///< side by side round the head
constexpr int kWidth = 256;         ///< a strand each
constexpr int kPieces = 16;         ///< of a strand, from top to bottom
constexpr int kPieceHeight = 8;     ///< px
constexpr int kHeight = kPieces * kPieceHeight;
/// Pieces on one unit of the mesh.
constexpr float kPiecesPerUnit = 0.48F;

/// A fixed pseudo-random number in [-1, 1].
float scattered(std::uint32_t n) {
  n = n * 747796405U + 2891336453U;
  n = ((n >> ((n >> 28U) + 4U)) ^ n) * 277803737U;
  return static_cast<float>((n >> 22U) ^ n) / 2147483648.0F - 1.0F;
}

/// How strongly a strand differs from its neighbours.
float contrast(bool grey) {
  return grey ? 0.78F : 0.42F;
}

/// How light strand `x` is at `y`, in [-1, 1]: pieces, each with places of its own.
float lightness(int x, int y) {
  const auto strand = static_cast<std::uint32_t>(x);
  const float shift = 0.5F * kPieces * (1 + scattered(strand + 90'000U));
  const float place = static_cast<float>(y) / kPieceHeight + shift;
  const auto piece = [&](float at) {
    return scattered(strand * 131U + static_cast<std::uint32_t>(at) % kPieces);
  };
  const float t = place - std::floor(place);
  const float along = std::lerp(piece(place), piece(place + 1), t * t * (3 - 2 * t));
  const float tuft = scattered(strand / 4 + 50'000U);
  return std::clamp(0.3F * scattered(strand) + 0.45F * along + 0.4F * tuft, -1.0F, 1.0F);
}

}  // namespace

view::Image strand_picture(bool grey) {
  view::Image picture = view::make_image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float light = (1 + contrast(grey) * lightness(x, y)) / strand_picture_gain(grey);
      const float length = 0.75F + 0.22F * scattered(static_cast<std::uint32_t>(x) + 7'000U);
      const auto at = static_cast<std::size_t>(4 * (y * kWidth + x));
      std::fill_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(at), 3, srgb_of_linear(light));
      picture.rgba[at + 3] = byte_of_share(length);
    }
  }
  return picture;
}

float strand_picture_gain(bool grey) {
  return 1 + contrast(grey);
}

std::vector<glm::vec2> strand_coordinates(const face::Face& face, const Surface& surface) {
  const auto* const strand = face::find_map(face.mesh, "strand");
  std::vector<glm::vec2> coordinates;
  for (const std::uint32_t i : surface.vertices) {
    const glm::vec3& p = face.mesh.positions[i];
    // Down, and slanting, so that strands that run to the back are no streaks either.
    const float round = 5.0F * std::abs(std::atan2(p.x, p.z - 1.5F)) - 0.6F * p.z;
    const float down = round - (p.y - 0.35F * p.z + 0.25F * p.x);
    coordinates.emplace_back(face::map_at(strand, i, 0) * kStrandsRound / kWidth,
                             down * kPiecesPerUnit / kPieces);
  }
  return coordinates;
}

}  // namespace aucast::glb
