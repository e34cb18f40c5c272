#include "client/view/camera.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "tests/support/seeded.h"

namespace aucast::view {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Where a point lands in the picture: x and y from -1 to 1, z its depth.
glm::vec3 place(const Camera& camera, int width, int height, glm::vec3 point) {
  const CameraMatrices matrices = camera_matrices(camera, width, height);
  const glm::vec4 clip = matrices.projection * matrices.view * glm::vec4(point, 1);
  return glm::vec3(clip) / clip.w;
}

TEST(CameraMatrices, PutTheTargetInTheMiddle) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const auto real = [&seeded](double low, double high) {
    return static_cast<float>(seeded.real(low, high));
  };
  for (int i = 0; i < 200; ++i) {
    Camera camera;
    camera.target = {real(-9, 9), real(-9, 9), real(-9, 9)};
    camera.yaw_rad = real(-3, 3);
    camera.pitch_rad = real(-1.3, 1.3);
    camera.half_height = real(1, 20);
    const glm::vec3 middle = place(camera, 800, 600, camera.target);
    EXPECT_NEAR(middle.x, 0, 1e-4);
    EXPECT_NEAR(middle.y, 0, 1e-4);
    EXPECT_GT(middle.z, -1);
    EXPECT_LT(middle.z, 1);
  }
}

TEST(CameraMatrices, SeeHalfHeightAtTheTarget) {
  Camera camera;
  camera.half_height = 7;
  const glm::vec3 top = place(camera, 800, 600, camera.target + glm::vec3(0, 7, 0));
  EXPECT_NEAR(top.y, 1, 1e-4);
  const glm::vec3 side = place(camera, 800, 600, camera.target + glm::vec3(7 * 800.0F / 600, 0, 0));
  EXPECT_NEAR(side.x, 1, 1e-4);
}

TEST(CameraMatrices, ShowTheSubjectsLeftOnTheRight) {
  const Camera camera;
  EXPECT_GT(place(camera, 300, 300, camera.target + glm::vec3(1, 0, 0)).x, 0);
}

TEST(CameraMatrices, StandOnTheSubjectsLeftForAPositiveYaw) {
  Camera camera;
  camera.yaw_rad = 0.5F * kPi;
  const glm::vec3 eye = camera_matrices(camera, 300, 300).eye;
  EXPECT_NEAR(eye.x, camera.target.x + camera.distance, 1e-3);
  EXPECT_NEAR(eye.z, camera.target.z, 1e-3);
  camera.yaw_rad = 0;
  camera.pitch_rad = 0.5F;
  EXPECT_GT(camera_matrices(camera, 300, 300).eye.y, camera.target.y);
}

TEST(CameraMatrices, NeverCutTheSidesOfANarrowPicture) {
  Camera camera;
  const glm::vec3 cheek = camera.target + glm::vec3(camera.half_height * 0.87F, 0, 0);
  EXPECT_NEAR(place(camera, 300, 375, cheek).x, 1, 1e-4);
  EXPECT_NEAR(place(camera, 100, 400, cheek).x, 1, 1e-4);
}

TEST(CameraMatrices, TakeSizesBelowOneAsOne) {
  const Camera camera;
  EXPECT_TRUE(std::isfinite(place(camera, 0, -3, camera.target).x));
}

TEST(CameraMatrices, KeepNearerThingsInFront) {
  const Camera camera;
  EXPECT_LT(place(camera, 300, 300, camera.target + glm::vec3(0, 0, 12)).z,
            place(camera, 300, 300, camera.target - glm::vec3(0, 0, 12)).z);
}

TEST(CameraPreset, KnowsItsThreeNames) {
  EXPECT_EQ(camera_preset("front"), CameraPreset::Front);
  EXPECT_EQ(camera_preset("three-quarter"), CameraPreset::ThreeQuarter);
  EXPECT_EQ(camera_preset("profile"), CameraPreset::Profile);
  for (const char* word : {"", "Front", "side", "profile "}) {
    EXPECT_FALSE(camera_preset(word).has_value()) << word;
  }
}

TEST(PortraitCamera, TurnsToTheSubjectsRight) {
  EXPECT_EQ(portrait_camera(CameraPreset::Front).yaw_rad, 0);
  EXPECT_LT(portrait_camera(CameraPreset::ThreeQuarter).yaw_rad, -0.4F);
  EXPECT_NEAR(portrait_camera(CameraPreset::Profile).yaw_rad, -0.5F * kPi, 1e-6);
}

TEST(Orbit, TurnsHalfRoundInOneHeight) {
  Camera camera;
  orbit(camera, -300, 0, 600);
  EXPECT_NEAR(camera.yaw_rad, 0.5F * kPi, 1e-5);
  orbit(camera, 300, 0, 600);
  EXPECT_NEAR(camera.yaw_rad, 0, 1e-5);
}

TEST(Orbit, StopsBeforeThePoles) {
  Camera camera;
  orbit(camera, 0, 1e6, 600);
  EXPECT_NEAR(camera.pitch_rad, 80 * kPi / 180, 1e-5);
  orbit(camera, 0, -1e7, 600);
  EXPECT_NEAR(camera.pitch_rad, -80 * kPi / 180, 1e-5);
}

TEST(Orbit, KeepsTheYawSmall) {
  Camera camera;
  for (int i = 0; i < 1000; ++i) orbit(camera, -250, 0, 600);
  EXPECT_LE(std::abs(camera.yaw_rad), kPi + 1e-5);
}

TEST(Pan, KeepsWhatIsUnderThePointerThere) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int i = 0; i < 100; ++i) {
    Camera camera;
    camera.yaw_rad = static_cast<float>(seeded.real(-3, 3));
    camera.pitch_rad = static_cast<float>(seeded.real(-1, 1));
    const glm::vec3 held = camera.target;
    pan(camera, 40, -30, 600);
    const glm::vec3 now = place(camera, 800, 600, held);
    EXPECT_NEAR(now.x, 40 / 400.0, 1e-3);
    EXPECT_NEAR(now.y, 30 / 300.0, 1e-3);
  }
}

TEST(Zoom, ComesCloserAndStaysInBounds) {
  Camera camera;
  const float before = camera.half_height;
  zoom(camera, 1);
  EXPECT_NEAR(camera.half_height, before * 0.9F, 1e-4);
  zoom(camera, 1000);
  EXPECT_FLOAT_EQ(camera.half_height, 0.5F);
  zoom(camera, -1000);
  EXPECT_FLOAT_EQ(camera.half_height, 40);
}

}  // namespace
}  // namespace aucast::view
