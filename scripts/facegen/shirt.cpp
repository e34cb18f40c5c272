#include "scripts/facegen/shirt.h"

#include "scripts/facegen/palette.h"
#include "scripts/facegen/sculpt.h"
#include "scripts/facegen/weights.h"

namespace aucast::facegen {
namespace {

/// A ring round the body: how far down (0 neck, 1 chest) and how far off the torso.
struct ShirtRing {
  double down;
  double off;
};

constexpr std::array<ShirtRing, 16> kRings{{// the collar, from inside over its edge
                                            {0.03, -0.12},
                                            {0.005, 0.00},
                                            {-0.006, 0.06},
                                            {-0.004, 0.11},
                                            {0.008, 0.15},
                                            {0.04, 0.17},
                                            {0.08, 0.17},
                                            {0.105, 0.155},
                                            {0.12, 0.11},
                                            // the body
                                            {0.14, 0.14},
                                            {0.24, 0.16},
                                            {0.38, 0.17},
                                            {0.54, 0.18},
                                            {0.70, 0.18},
                                            {0.86, 0.18},
                                            {1.0, 0.18}}};
constexpr std::size_t kCollarRings = 9;
constexpr int kSectors = 96;

/// Cloth hangs between collar and shoulder instead of following every hollow.
void hang(Part& shirt) {
  constexpr int kPasses = 6;
  const auto at = [](std::size_t ring, int sector) {
    return ring * kSectors + static_cast<std::size_t>((sector + kSectors) % kSectors);
  };
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<Vertex> before = shirt.vertices;
    for (std::size_t k = kCollarRings; k + 1 < kRings.size(); ++k) {
      for (int i = 0; i < kSectors; ++i) {
        const Vec3 sum = before[at(k - 1, i)].position + before[at(k + 1, i)].position +
                         before[at(k, i - 1)].position + before[at(k, i + 1)].position;
        Vec3& position = shirt.vertices[at(k, i)].position;
        position = mix(position, sum / 4.0, 0.6);
      }
    }
  }
}

}  // namespace

Part make_shirt(const Identity& who) {
  Part shirt;
  shirt.name = "shirt";
  shirt.material = face::Material::Cloth;
  const Distance torso = [&who](const Vec3& at) { return torso_distance(who.form, at); };
  std::vector<std::uint32_t> above;
  for (std::size_t k = 0; k < kRings.size(); ++k) {
    const double elevation = mix(0.02, -0.95, kRings[k].down);
    std::vector<std::uint32_t> ring;
    for (int i = 0; i < kSectors; ++i) {
      const double angle = 2 * kPi * i / kSectors;
      const double front = std::cos(angle);
      // The collar stands lower under the chin.
      const Vec3 origin{0, -7.95 - 0.80 * (front * 0.5 + 0.5), -0.8};
      const Vec3 direction{std::sin(angle) * std::cos(elevation),
                           std::sin(elevation) - 0.22 * front * (1 - kRings[k].down),
                           front * std::cos(elevation)};
      Vec3 p = leave(origin, direction, torso);
      p += glm::normalize(Vec3{p.x - origin.x, 0.6, p.z - origin.z}) * kRings[k].off;
      ring.push_back(shirt.add(p, k < kCollarRings ? who.colours.collar : who.colours.cloth));
    }
    if (k > 0) shirt.add_band(ring, above, true);
    above = std::move(ring);
  }
  hang(shirt);
  shirt.fill(Map::Head, kShoulders);
  return shirt;
}

}  // namespace aucast::facegen
