#include "client/view/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace aucast::view {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kPitchMaxRad = 80.0F * kPi / 180.0F;
constexpr float kHalfHeightMin = 0.5F;
constexpr float kHalfHeightMax = 40.0F;
constexpr float kNarrowestFull = 0.87F;
/// Half the depth around the target that is drawn, mesh units: enough for a head with shoulders
/// from any side.
constexpr float kHalfDepth = 30.0F;

glm::vec3 direction_to_eye(const Viewpoint& viewpoint) {
  return {std::sin(viewpoint.yaw_rad) * std::cos(viewpoint.pitch_rad),
          std::sin(viewpoint.pitch_rad),
          std::cos(viewpoint.yaw_rad) * std::cos(viewpoint.pitch_rad)};
}

}  // namespace

ViewMatrices view_matrices(const Viewpoint& viewpoint, int width, int height) {
  const float aspect =
      static_cast<float>(std::max(width, 1)) / static_cast<float>(std::max(height, 1));
  const float half_height = viewpoint.half_height * std::max(1.0F, kNarrowestFull / aspect);
  const float near_plane = std::max(viewpoint.distance - kHalfDepth, viewpoint.distance * 0.05F);
  const float top = half_height / viewpoint.distance * near_plane;
  ViewMatrices matrices;
  matrices.eye = viewpoint.target + direction_to_eye(viewpoint) * viewpoint.distance;
  matrices.view = glm::lookAt(matrices.eye, viewpoint.target, glm::vec3(0, 1, 0));
  matrices.projection = glm::frustum(-top * aspect, top * aspect, -top, top, near_plane,
                                     viewpoint.distance + kHalfDepth);
  return matrices;
}

std::string_view name(ViewpointPreset preset) {
  switch (preset) {
    case ViewpointPreset::Front:
      break;
    case ViewpointPreset::ThreeQuarter:
      return "three-quarter";
    case ViewpointPreset::Profile:
      return "profile";
  }
  return "front";
}

Viewpoint portrait_viewpoint(ViewpointPreset preset) {
  Viewpoint viewpoint;
  if (preset == ViewpointPreset::ThreeQuarter) {
    viewpoint.yaw_rad = -0.60F;
    viewpoint.pitch_rad = 0.03F;
  } else if (preset == ViewpointPreset::Profile) {
    viewpoint.yaw_rad = -0.5F * kPi;
  }
  return viewpoint;
}

void orbit(Viewpoint& viewpoint, double right_px, double down_px, int height) {
  const float rad_per_px = kPi / static_cast<float>(std::max(height, 1));
  const float yaw = viewpoint.yaw_rad - static_cast<float>(right_px) * rad_per_px;
  viewpoint.yaw_rad = std::remainder(yaw, 2.0F * kPi);
  viewpoint.pitch_rad = std::clamp(viewpoint.pitch_rad + static_cast<float>(down_px) * rad_per_px,
                                   -kPitchMaxRad, kPitchMaxRad);
}

void pan(Viewpoint& viewpoint, double right_px, double down_px, int height) {
  const float units_per_px = 2.0F * viewpoint.half_height / static_cast<float>(std::max(height, 1));
  const glm::vec3 to_eye = direction_to_eye(viewpoint);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), to_eye));
  const glm::vec3 up = glm::cross(to_eye, right);
  viewpoint.target +=
      (up * static_cast<float>(down_px) - right * static_cast<float>(right_px)) * units_per_px;
}

void zoom(Viewpoint& viewpoint, double steps) {
  viewpoint.half_height =
      std::clamp(viewpoint.half_height * std::pow(0.9F, static_cast<float>(steps)), kHalfHeightMin,
                 kHalfHeightMax);
}

}  // namespace aucast::view
