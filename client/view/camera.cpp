#include "client/view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace aucast::view {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kPitchMax_rad = 80.0F * kPi / 180.0F;
constexpr float kHalfHeightMin = 0.5F;
constexpr float kHalfHeightMax = 40.0F;
constexpr float kNarrowestFull = 0.87F;
/// Half the depth that is drawn, around the target: a head with shoulders from any side.
constexpr float kHalfDepth = 30.0F;

glm::vec3 direction_to_eye(const Camera& camera) {
  return {std::sin(camera.yaw_rad) * std::cos(camera.pitch_rad), std::sin(camera.pitch_rad),
          std::cos(camera.yaw_rad) * std::cos(camera.pitch_rad)};
}

}  // namespace

CameraMatrices camera_matrices(const Camera& camera, int width, int height) {
  const float aspect =
      static_cast<float>(std::max(width, 1)) / static_cast<float>(std::max(height, 1));
  const float half_height = camera.half_height * std::max(1.0F, kNarrowestFull / aspect);
  const float near_plane = std::max(camera.distance - kHalfDepth, camera.distance * 0.05F);
  const float top = half_height / camera.distance * near_plane;
  CameraMatrices matrices;
  matrices.eye = camera.target + direction_to_eye(camera) * camera.distance;
  matrices.view = glm::lookAt(matrices.eye, camera.target, glm::vec3(0, 1, 0));
  matrices.projection = glm::frustum(-top * aspect, top * aspect, -top, top, near_plane,
                                     camera.distance + kHalfDepth);
  return matrices;
}

std::optional<CameraPreset> camera_preset(std::string_view name) {
  if (name == "front") return CameraPreset::Front;
  if (name == "three-quarter") return CameraPreset::ThreeQuarter;
  if (name == "profile") return CameraPreset::Profile;
  return std::nullopt;
}

Camera portrait_camera(CameraPreset preset) {
  Camera camera;
  if (preset == CameraPreset::ThreeQuarter) {
    camera.yaw_rad = -0.60F;
    camera.pitch_rad = 0.03F;
  } else if (preset == CameraPreset::Profile) {
    camera.yaw_rad = -0.5F * kPi;
  }
  return camera;
}

void orbit(Camera& camera, double right_px, double down_px, int height) {
  const float rad_per_px = kPi / static_cast<float>(std::max(height, 1));
  const float yaw = camera.yaw_rad - static_cast<float>(right_px) * rad_per_px;
  camera.yaw_rad = std::remainder(yaw, 2.0F * kPi);
  camera.pitch_rad = std::clamp(camera.pitch_rad + static_cast<float>(down_px) * rad_per_px,
                                -kPitchMax_rad, kPitchMax_rad);
}

void pan(Camera& camera, double right_px, double down_px, int height) {
  const float units_per_px = 2.0F * camera.half_height / static_cast<float>(std::max(height, 1));
  const glm::vec3 to_eye = direction_to_eye(camera);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), to_eye));
  const glm::vec3 up = glm::cross(to_eye, right);
  camera.target +=
      (up * static_cast<float>(down_px) - right * static_cast<float>(right_px)) * units_per_px;
}

void zoom(Camera& camera, double steps) {
  camera.half_height = std::clamp(camera.half_height * std::pow(0.9F, static_cast<float>(steps)),
                                  kHalfHeightMin, kHalfHeightMax);
}

}  // namespace aucast::view
