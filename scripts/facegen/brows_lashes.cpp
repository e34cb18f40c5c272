#include "scripts/facegen/brows_lashes.h"

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/palette.h"
#include "scripts/facegen/sculpt.h"
#include "scripts/facegen/weights.h"

namespace aucast::facegen {
namespace {

/// Where a lash stands and how it grows; t runs from the inner corner of the eye to the outer one.
Vec3 lash_direction(bool upper, double t, const Vec3& out, double side) {
  const Vec3 up{0, upper ? 0.35 : -0.5, 0};
  const Vec3 outwards{side * (upper ? 0.9 * (t - 0.35) : 0.6 * (t - 0.4)), 0, 0};
  return glm::normalize(out + up + outwards);
}

double lash_length(bool upper, double t) {
  if (!upper) return 0.10 * std::sin(kPi * power(t, 0.8));
  // Longer towards the temple.
  return 0.34 * std::sin(kPi * power(t, 0.75)) * (0.45 + 0.85 * t) +
         0.10 * smooth_step(0.7, 1.0, t);
}

void add_lashes(Part& part, const Skin& skin, int side, bool upper) {
  constexpr int kAlong = 16;
  const Vec3 eye{side * kEyeCentre.x, kEyeCentre.y, kEyeCentre.z};
  std::vector<std::uint32_t> before;
  for (int k = 0; k <= kAlong; ++k) {
    const double t = static_cast<double>(k) / kAlong;
    const int from_canthus = upper ? k : (32 - k) % 32;
    const int spoke = (from_canthus - 4 + kEyeSpokes) % kEyeSpokes;
    const Vertex& root = skin.part.vertices[skin.find(Patch::Eye, kLidMarginRing, spoke, side)];
    const Vec3 out = glm::normalize(root.position - eye);
    const Vec3 direction = lash_direction(upper, t, out, side);
    const double length = lash_length(upper, t);
    const double strand = 0.75 + 0.25 * (k % 2);
    const std::array<double, 3> alphas{0.95, 0.75 * strand, 0.0};
    std::vector<std::uint32_t> ray;
    for (std::size_t j = 0; j < alphas.size(); ++j) {
      const double s = static_cast<double>(j) / 2;
      Vec3 p = root.position - out * 0.01 + direction * (length * s) +
               Vec3{0, (upper ? 0.35 : -0.2) * length * s * s, 0};
      if (j == 0) p.y += upper ? -0.03 : 0.015;
      const double alpha = alphas[j] * (upper ? 1 : 0.45) * smooth_step(-0.02, 0.10, t);
      ray.push_back(part.add(p, kLash, alpha));
      part.vertices.back().maps = root.maps;
      part.vertices.back().gloss = 0;
    }
    if (k > 0) {
      const bool inward = (side > 0) != upper;
      if (inward) {
        part.add_band(before, ray, false);
      } else {
        part.add_band(ray, before, false);
      }
    }
    before = std::move(ray);
  }
}

}  // namespace

Part make_brow(const Identity& who, int side) {
  constexpr int kAlong = 40;
  constexpr int kAcross = 6;
  Part brow;
  brow.name = side > 0 ? "left_brow" : "right_brow";
  brow.material = face::Material::Brow;
  std::vector<std::uint32_t> before;
  for (int i = 0; i <= kAlong; ++i) {
    const double t = static_cast<double>(i) / kAlong;
    const Vec3 spine = brow_spine(who, t);
    const Vec3 along = glm::normalize(brow_spine(who, std::min(1.0, t + 0.01)) -
                                      brow_spine(who, std::max(0.0, t - 0.01)));
    const Vec3 across{-along.y, along.x, 0};
    const double half_width = std::max(0.012, brow_half_width(who, t));
    const double ends = smooth_step(0, 0.15, t) * smooth_step(1.05, 0.7, t);
    std::vector<std::uint32_t> row;
    for (int j = 0; j <= kAcross; ++j) {
      const double s = 2.0 * j / kAcross - 1;
      Vec3 p = spine + across * (half_width * s);
      p.z = face_z(who, p.x, p.y);
      p += head_normal(who, p, 0.05) * (0.015 + 0.075 * (1 - s * s) * ends);
      p.x *= side;
      const Vec3 colour = who.colours.brow * (0.85 + 0.3 * hash(i * 7 + j * 131));
      const double alpha = 0.97 * smooth_step(-0.02, 0.12, t) * (1 - smooth_step(0.95, 1.02, t)) *
                           smooth_step(1.02, 0.55, std::abs(s));
      row.push_back(brow.add(p, colour, alpha));
      weigh_by_position(who, brow.vertices.back());
    }
    if (i > 0) {
      if (side > 0) {
        brow.add_band(before, row, false);
      } else {
        brow.add_band(row, before, false);
      }
    }
    before = std::move(row);
  }
  return brow;
}

Part make_lashes(const Skin& skin) {
  Part lashes;
  lashes.name = "lashes";
  lashes.material = face::Material::Brow;
  for (const int side : {1, -1}) {
    for (const bool upper : {true, false}) add_lashes(lashes, skin, side, upper);
  }
  return lashes;
}

}  // namespace aucast::facegen
