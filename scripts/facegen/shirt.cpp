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

constexpr std::size_t kCollarRings = 9;
/// The collar, from inside over its edge: a round band ...
constexpr std::array<ShirtRing, kCollarRings> kBand{{{0.03, -0.12},
                                                     {0.005, 0.00},
                                                     {-0.006, 0.06},
                                                     {-0.004, 0.11},
                                                     {0.008, 0.15},
                                                     {0.04, 0.17},
                                                     {0.08, 0.17},
                                                     {0.105, 0.155},
                                                     {0.12, 0.11}}};
/// ... or one that is turned down. Its way down from the fold is in shares of its length.
constexpr std::array<ShirtRing, kCollarRings> kTurned{{{0.06, -0.10},
                                                       {0.01, 0.00},
                                                       {-0.03, 0.10},
                                                       {-0.02, 0.22},
                                                       {0.12, 0.32},
                                                       {0.55, 0.37},
                                                       {1.0, 0.36},
                                                       {1.01, 0.28},
                                                       {0.80, 0.12}}};
constexpr std::array<ShirtRing, 7> kBody{{{0.14, 0.14},
                                          {0.24, 0.16},
                                          {0.38, 0.17},
                                          {0.54, 0.18},
                                          {0.70, 0.18},
                                          {0.86, 0.18},
                                          {1.0, 0.18}}};
constexpr std::size_t kRings = kCollarRings + kBody.size();
constexpr int kSectors = 96;

/// How far down a turned collar reaches at `angle` from the front: two points, and between them a
/// gap that opens downwards.
double collar_length(double angle) {
  const double from_front = std::abs(angle);
  return std::min(0.02 + 1.05 * from_front, mix(0.46, 0.19, smooth_step(0.30, 1.1, from_front)));
}

/// Height of the folds in which cloth hangs, from the collar outwards and down.
double folds(double angle, double down) {
  const double side = angle < 0 ? 0.37 : 0;
  const double from_front = std::abs(angle);
  const auto fold = [&](double at, double lean, double width) {
    return bell(from_front - at - side * 0.2 - lean * down, width);
  };
  const double begun = smooth_step(0.10, 0.20, down) * smooth_step(1.0, 0.6, down);
  return begun * (0.24 * fold(0.42, 0.50, 0.07) - 0.16 * fold(0.58, 0.55, 0.08) +
                  0.26 * fold(0.95, 0.35, 0.09) - 0.18 * fold(1.16, 0.30, 0.10) +
                  0.20 * fold(1.45, -0.20, 0.08));
}

/// Cloth hangs between collar and shoulder instead of following every hollow.
void hang(Part& shirt) {
  constexpr int kPasses = 6;
  const auto at = [](std::size_t ring, int sector) {
    return ring * kSectors + static_cast<std::size_t>((sector + kSectors) % kSectors);
  };
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<Vertex> before = shirt.vertices;
    for (std::size_t k = kCollarRings; k + 1 < kRings; ++k) {
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
  const double turned = who.form.collar;
  std::vector<std::uint32_t> above;
  for (std::size_t k = 0; k < kRings; ++k) {
    std::vector<std::uint32_t> ring;
    for (int i = 0; i < kSectors; ++i) {
      const double angle = std::remainder(2 * kPi * i / kSectors, 2 * kPi);
      const double front = std::cos(angle);
      ShirtRing at = k < kCollarRings ? kBand[k] : kBody[k - kCollarRings];
      if (k < kCollarRings) {
        const ShirtRing& fall = kTurned[k];
        at.down = mix(at.down, k < 4 ? fall.down : fall.down * collar_length(angle), turned);
        at.off = mix(at.off, fall.off, turned);
      }
      const double elevation = mix(0.02, -0.95, at.down);
      // The collar stands lower under the chin.
      const double low = mix(0.80, 0.95, turned) * (front * 0.5 + 0.5);
      const Vec3 origin{0, mix(-7.50, -7.25, turned) - low, -0.8};
      const Vec3 direction{std::sin(angle) * std::cos(elevation),
                           std::sin(elevation) - 0.22 * front * (1 - at.down),
                           front * std::cos(elevation)};
      Vec3 p = leave(origin, direction, torso);
      const double off = at.off + (k < kCollarRings ? 0 : folds(angle, at.down));
      p += glm::normalize(Vec3{p.x - origin.x, 0.6, p.z - origin.z}) * off;
      // Both sides of the seam lie in its shade.
      const double seam = k == kCollarRings - 1 || k == kCollarRings ? 0.72 : 1;
      ring.push_back(
          shirt.add(p, (k < kCollarRings ? who.colours.collar : who.colours.cloth) * seam));
    }
    if (k > 0) shirt.add_band(ring, above, true);
    above = std::move(ring);
  }
  hang(shirt);
  shirt.fill(Map::Head, kShoulders);
  return shirt;
}

}  // namespace aucast::facegen
