#pragma once

#include "scripts/facegen/maths.h"

namespace aucast::facegen {

// Signed distances, negative inside, and ways to melt them into each other. They are accurate near
// the surface only, which is enough to project points onto it.

/// Union with a rounded seam about `radius` wide. Cubic, because the usual quadratic one leaves
/// lines in the shading where its second derivative jumps.
[[nodiscard]] inline double melt(double a, double b, double radius) {
  const double k = radius * 1.25;
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * h * k / 6;
}

/// What is in `a` but not in `hollow`, with a rounded edge.
[[nodiscard]] inline double carve(double a, double hollow, double radius) {
  return -melt(-a, hollow, radius);
}

/// |x| with a rounded bottom: what is mirrored with it has no crease at x = 0.
[[nodiscard]] inline double soft_abs(double x, double radius) {
  return std::sqrt(x * x + radius * radius);
}

/// Approximate distance to an ellipsoid about the origin; exact to first order at the surface.
[[nodiscard]] inline double ellipsoid(const Vec3& p, const Vec3& radii) {
  const Vec3 q = p / radii;
  const double k0 = glm::length(q);
  const double k1 = glm::length(q / radii);
  return k1 > 1e-9 ? k0 * (k0 - 1) / k1 : -std::min({radii.x, radii.y, radii.z});
}

/// The hull of two spheres of different radius.
[[nodiscard]] double round_cone(const Vec3& p, const Vec3& a, const Vec3& b, double radius_a,
                                double radius_b);

}  // namespace aucast::facegen
