#include "client/face/muscle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include <glm/geometric.hpp>

namespace aucast::face {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2;
constexpr float kUncapped = std::numeric_limits<float>::infinity();

/// Beyond this many radii a local pull is nothing; its Gaussian is lowered by its value there
/// (1.2e-4), so that it ends without a step.
constexpr double kPullRadii = 3;

/// 1 up to three quarters of `depth`, from there smoothly to 0 at `depth`: a plain limit in depth
/// would tear skin that runs through it.
double depth_fade(double distance, double depth) {
  const double t = std::clamp(4 * (1 - std::abs(distance) / depth), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Thesis eq. 3.1-3.4 in the form of Waters' released program.
LinearInfluence influence_of(const LinearMuscle& muscle, const glm::dvec3& point) {
  const glm::dvec3 attachment(muscle.attachment);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(muscle.insertion) - attachment);
  const glm::dvec3 from_attachment = point - attachment;
  const double distance = glm::length(from_attachment);
  if (distance <= 0 || distance >= muscle.falloff_finish) return {};
  const double cos_zone = std::cos(static_cast<double>(muscle.zone_rad));
  const double cos_angle = glm::dot(from_attachment, axis) / distance;
  if (cos_angle <= cos_zone) return {};
  const double angular = (cos_angle - cos_zone) / (1 - cos_zone);
  const double start = muscle.falloff_start;
  const double radial =
      distance < start ? 1.0
                       : std::cos(kHalfPi * (distance - start) / (muscle.falloff_finish - start));
  const double gain = 1 / cos_zone - 1;
  LinearInfluence result;
  result.per_unit = glm::vec3(-from_attachment * (gain * angular * radial));
  result.activation_cap = muscle.cap ? static_cast<float>(*muscle.cap / gain) : kUncapped;
  return result;
}

/// Thesis eq. 3.5-3.9, clean form: K s f g2 towards the centre with s = lx / 2,
/// and K f (1 - rho/lx) / Z forward.
LinearInfluence influence_of(const MouthSphincter& muscle, const glm::dvec3& point) {
  const glm::dvec3 to_centre = glm::dvec3(muscle.centre) - point;
  const glm::dvec2 axes(muscle.semi_axes);
  const double f = 1 - std::hypot(to_centre.x / axes.x, to_centre.y / axes.y);
  const double fade = depth_fade(to_centre.z, muscle.depth);
  if (f <= 0 || fade <= 0) return {};
  const double rho = std::hypot(to_centre.x, to_centre.y);
  const double g2 = rho > axes.y ? (rho - axes.y) / (axes.x - axes.y) : 0.0;
  const double inwards = rho > 0 ? 0.5 * axes.x * f * g2 / rho : 0.0;
  const double forward = f * (1 - rho / axes.x) / muscle.protrusion;
  return {glm::vec3(fade * glm::dvec3(inwards * to_centre.x, inwards * to_centre.y, forward)),
          kUncapped};
}

/// Thesis eq. 3.10-3.13, clean form. The share belongs to the lids' way only: in
/// z it would step on the axis.
LinearInfluence influence_of(const EyeSphincter& muscle, const glm::dvec3& point) {
  const glm::dvec3 from_centre = point - glm::dvec3(muscle.centre);
  const glm::dvec2 axes(muscle.semi_axes);
  const double f = 1 - std::hypot(from_centre.x / axes.x, from_centre.y / axes.y);
  const double fade = depth_fade(from_centre.z, muscle.depth);
  if (f <= 0 || fade <= 0) return {};
  const double share = from_centre.y > 0 ? muscle.upper_share : muscle.lower_share;
  const double bulge = f * (1 - std::abs(from_centre.y) / axes.y) / muscle.bulge;
  return {glm::vec3(fade * glm::dvec3(0, -0.5 * f * share * from_centre.y, bulge)), kUncapped};
}

/// Thesis eq. 3.14-3.19, clean form: K s D cos(pi w/W) towards the attachment
/// with s = L / pi, so that nothing folds for K up to 2.
LinearInfluence influence_of(const SheetMuscle& muscle, const glm::dvec3& point) {
  const glm::dvec3 span = glm::dvec3(muscle.insertion) - glm::dvec3(muscle.attachment);
  const double length = glm::length(span);
  const glm::dvec3 axis = span / length;
  // The sheet lies across the viewer's direction; one that points at the viewer lies level.
  const glm::dvec3 across = glm::cross(axis, glm::dvec3(0, 0, 1));
  const glm::dvec3 side = glm::length(across) > 1e-6 ? glm::normalize(across) : glm::dvec3(1, 0, 0);
  const glm::dvec3 normal = glm::cross(side, axis);
  const glm::dvec3 from_attachment = point - glm::dvec3(muscle.attachment);
  const double along = glm::dot(from_attachment, axis) / length;
  const double aside = glm::dot(from_attachment, side) / muscle.width;
  const double fade = depth_fade(glm::dot(from_attachment, normal), muscle.depth);
  if (along <= 0 || along >= 1 || std::abs(aside) >= 0.5 || fade <= 0) return {};
  const double peak = muscle.peak;
  const double profile = along <= peak ? std::cos((1 - along / peak) * kHalfPi)
                                       : std::cos((along - peak) / (1 - peak) * kHalfPi);
  const double way =
      peak * length / std::numbers::pi * profile * std::cos(std::numbers::pi * aside) * fade;
  return {glm::vec3(-way * axis), kUncapped};
}

LinearInfluence influence_of(const LocalPull& muscle, const glm::dvec3& point) {
  const glm::dvec3 scaled = (point - glm::dvec3(muscle.centre)) / glm::dvec3(muscle.radii);
  const double edge = std::exp(-kPullRadii * kPullRadii);
  const double falloff = (std::exp(-glm::dot(scaled, scaled)) - edge) / (1 - edge);
  if (falloff <= 0) return {};
  return {glm::vec3(falloff * glm::dvec3(muscle.direction)), kUncapped};
}

}  // namespace

LinearInfluence influence(const MuscleShape& shape, const glm::vec3& point) {
  return std::visit([&](const auto& muscle) { return influence_of(muscle, glm::dvec3(point)); },
                    shape);
}

}  // namespace aucast::face
