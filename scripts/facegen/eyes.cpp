#include "scripts/facegen/eyes.h"

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/palette.h"

namespace aucast::facegen {
namespace {

constexpr int kEyeSectors = 60;
constexpr double kPupilRadius = 0.22;
/// How far each eye turns in at rest, radians: parallel, they look past the viewer.
constexpr double kConvergence = 0.022;

/// Colour at `radius` from the eye's axis and `angle` about it; the nose lies at `nasal` 1.
Vec3 eye_colour(const Identity& who, double radius, int sector, double angle, double nasal) {
  if (radius < kPupilRadius) return kPupil;
  if (radius < kIrisRadius) {
    const double t = (radius - kPupilRadius) / (kIrisRadius - kPupilRadius);
    const double streak = hash(sector * 13 + 7) * 0.5 + hash(sector / 3 * 31 + 3) * 0.5;
    Vec3 c = mix(who.colours.iris_inner, who.colours.iris_outer,
                 smooth_step(0.1, 0.65, t + 0.25 * (streak - 0.5)));
    // Light from above shines through to the lower half.
    const double arc = smooth_step(0.30, 0.60, t) * smooth_step(-0.3, -1.0, std::sin(angle));
    c *= (0.70 + 0.6 * streak) * (0.92 - 0.34 * std::sin(angle) + 0.44 * arc);
    c = mix(c, kIrisEdge, 0.85 * smooth_step(0.66, 1.02, t));
    return t < 0.08 ? c * 0.35 : c;
  }
  // Faint: all of it comes into view when the eye looks aside.
  const double corner = smooth_step(0.52, 1.02, radius);
  Vec3 c = mix(kSclera, kScleraCorner, 0.85 * corner);
  // Fine vessels, which the middle hardly has.
  const double vessel = power(hash(sector / 2 * 41 + 5), 3.0) * (0.4 + 0.6 * hash(sector * 17 + 2));
  c *= Vec3{1} - Vec3{0.04, 0.22, 0.24} * (vessel * smooth_step(0.60, 0.95, radius));
  c = mix(c, kCaruncle, 0.55 * smooth_step(0.90, 1.20, radius) * smooth_step(0.6, 0.9, nasal));
  if (radius > kIrisRadius + 0.11) return c;
  return mix(kLimbus, c, mix(0.40, 0.62, hash(sector / 4 * 23 + 11)));
}

/// How far the edge of the iris is from a circle, share of its radius: drawn with compasses, it is
/// a doll's.
double uneven(double angle, int side) {
  return 0.014 * std::sin(3 * angle + 0.7 * side) + 0.011 * std::sin(5 * angle + 2.1 + side);
}

}  // namespace

Part make_eye(const Identity& who, int side) {
  static constexpr std::array kFrontRings{0.10,
                                          kPupilRadius - 0.015,
                                          kPupilRadius + 0.015,
                                          0.25,
                                          0.305,
                                          0.36,
                                          0.42,
                                          kIrisRadius - 0.015,
                                          kIrisRadius + 0.100,
                                          0.66,
                                          0.76,
                                          0.86,
                                          0.95,
                                          1.03,
                                          1.23};
  static constexpr std::array kBackDepths{0.0, -0.6, -1.0};
  Part eye;
  eye.name = side > 0 ? "left_eye" : "right_eye";
  eye.material = face::Material::Eye;
  const Vec3 centre = eye_centre(who.form) * Vec3{side, 1, 1};
  const auto place = [&](const Vec3& from_centre) {
    return centre + rotated_y(from_centre, -side * kConvergence);
  };
  const std::uint32_t pole = eye.add(place({0, 0, kEyeRadius}), kPupil);
  std::vector<std::uint32_t> inner;
  const auto add_ring = [&](double radius, double z) {
    std::vector<std::uint32_t> ring;
    const double at_iris = bell(radius - kIrisRadius, 0.10);
    for (int i = 0; i < kEyeSectors; ++i) {
      const double angle = 2 * kPi * i / kEyeSectors;
      const double r = radius * (1 + at_iris * uneven(angle, side));
      const double forward = z > 0 ? std::sqrt(kEyeRadius * kEyeRadius - r * r) : z;
      ring.push_back(eye.add(place({r * std::cos(angle), r * std::sin(angle), forward}),
                             eye_colour(who, radius, i, angle, -side * std::cos(angle))));
    }
    if (inner.empty()) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        eye.add_triangle(pole, ring[i], ring[(i + 1) % ring.size()]);
      }
    } else {
      eye.add_band(ring, inner, true);
    }
    inner = std::move(ring);
  };
  for (const double r : kFrontRings) {
    add_ring(r, std::sqrt(kEyeRadius * kEyeRadius - r * r));
  }
  for (const double z : kBackDepths) add_ring(std::sqrt(kEyeRadius * kEyeRadius - z * z), z);
  eye.fill(Map::Head, 1);
  return eye;
}

}  // namespace aucast::facegen
