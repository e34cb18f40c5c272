#include "client/view/viewpoint.h"

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
glm::vec3 place(const Viewpoint& viewpoint, int width, int height, glm::vec3 point) {
  const ViewMatrices matrices = view_matrices(viewpoint, width, height);
  const glm::vec4 clip = matrices.projection * matrices.view * glm::vec4(point, 1);
  return glm::vec3(clip) / clip.w;
}

TEST(ViewMatrices, PutTheTargetInTheMiddle) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const auto real = [&seeded](double low, double high) {
    return static_cast<float>(seeded.real(low, high));
  };
  for (int i = 0; i < 200; ++i) {
    Viewpoint viewpoint;
    viewpoint.target = {real(-9, 9), real(-9, 9), real(-9, 9)};
    viewpoint.yaw_rad = real(-3, 3);
    viewpoint.pitch_rad = real(-1.3, 1.3);
    viewpoint.half_height = real(1, 20);
    const glm::vec3 middle = place(viewpoint, 800, 600, viewpoint.target);
    EXPECT_NEAR(middle.x, 0, 1e-4);
    EXPECT_NEAR(middle.y, 0, 1e-4);
    EXPECT_GT(middle.z, -1);
    EXPECT_LT(middle.z, 1);
  }
}

TEST(ViewMatrices, SeeHalfHeightAtTheTarget) {
  Viewpoint viewpoint;
  viewpoint.half_height = 7;
  const glm::vec3 top = place(viewpoint, 800, 600, viewpoint.target + glm::vec3(0, 7, 0));
  EXPECT_NEAR(top.y, 1, 1e-4);
  const glm::vec3 side =
      place(viewpoint, 800, 600, viewpoint.target + glm::vec3(7 * 800.0F / 600, 0, 0));
  EXPECT_NEAR(side.x, 1, 1e-4);
}

TEST(ViewMatrices, ShowTheSubjectsLeftOnTheRight) {
  const Viewpoint viewpoint;
  EXPECT_GT(place(viewpoint, 300, 300, viewpoint.target + glm::vec3(1, 0, 0)).x, 0);
}

TEST(ViewMatrices, StandOnTheSubjectsLeftForAPositiveYaw) {
  Viewpoint viewpoint;
  viewpoint.yaw_rad = 0.5F * kPi;
  const glm::vec3 eye = view_matrices(viewpoint, 300, 300).eye;
  EXPECT_NEAR(eye.x, viewpoint.target.x + viewpoint.distance, 1e-3);
  EXPECT_NEAR(eye.z, viewpoint.target.z, 1e-3);
  viewpoint.yaw_rad = 0;
  viewpoint.pitch_rad = 0.5F;
  EXPECT_GT(view_matrices(viewpoint, 300, 300).eye.y, viewpoint.target.y);
}

TEST(ViewMatrices, NeverCutTheSidesOfANarrowPicture) {
  Viewpoint viewpoint;
  const glm::vec3 cheek = viewpoint.target + glm::vec3(viewpoint.half_height * 0.87F, 0, 0);
  EXPECT_NEAR(place(viewpoint, 300, 375, cheek).x, 1, 1e-4);
  EXPECT_NEAR(place(viewpoint, 100, 400, cheek).x, 1, 1e-4);
}

TEST(ViewMatrices, TakeSizesBelowOneAsOne) {
  const Viewpoint viewpoint;
  EXPECT_TRUE(std::isfinite(place(viewpoint, 0, -3, viewpoint.target).x));
}

TEST(ViewMatrices, KeepNearerThingsInFront) {
  const Viewpoint viewpoint;
  EXPECT_LT(place(viewpoint, 300, 300, viewpoint.target + glm::vec3(0, 0, 12)).z,
            place(viewpoint, 300, 300, viewpoint.target - glm::vec3(0, 0, 12)).z);
}

TEST(ViewpointPreset, KnowsItsThreeNames) {
  EXPECT_EQ(name(ViewpointPreset::Front), "front");
  EXPECT_EQ(name(ViewpointPreset::ThreeQuarter), "three-quarter");
  EXPECT_EQ(name(ViewpointPreset::Profile), "profile");
}

TEST(PortraitViewpoint, TurnsToTheSubjectsRight) {
  EXPECT_EQ(portrait_viewpoint(ViewpointPreset::Front).yaw_rad, 0);
  EXPECT_LT(portrait_viewpoint(ViewpointPreset::ThreeQuarter).yaw_rad, -0.4F);
  EXPECT_NEAR(portrait_viewpoint(ViewpointPreset::Profile).yaw_rad, -0.5F * kPi, 1e-6);
}

TEST(Orbit, TurnsHalfRoundInOneHeight) {
  Viewpoint viewpoint;
  orbit(viewpoint, -300, 0, 600);
  EXPECT_NEAR(viewpoint.yaw_rad, 0.5F * kPi, 1e-5);
  orbit(viewpoint, 300, 0, 600);
  EXPECT_NEAR(viewpoint.yaw_rad, 0, 1e-5);
}

TEST(Orbit, StopsBeforeThePoles) {
  Viewpoint viewpoint;
  orbit(viewpoint, 0, 1e6, 600);
  EXPECT_NEAR(viewpoint.pitch_rad, 80 * kPi / 180, 1e-5);
  orbit(viewpoint, 0, -1e7, 600);
  EXPECT_NEAR(viewpoint.pitch_rad, -80 * kPi / 180, 1e-5);
}

TEST(Orbit, KeepsTheYawSmall) {
  Viewpoint viewpoint;
  for (int i = 0; i < 1000; ++i) orbit(viewpoint, -250, 0, 600);
  EXPECT_LE(std::abs(viewpoint.yaw_rad), kPi + 1e-5);
}

TEST(Pan, KeepsWhatIsUnderThePointerThere) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int i = 0; i < 100; ++i) {
    Viewpoint viewpoint;
    viewpoint.yaw_rad = static_cast<float>(seeded.real(-3, 3));
    viewpoint.pitch_rad = static_cast<float>(seeded.real(-1, 1));
    const glm::vec3 held = viewpoint.target;
    pan(viewpoint, 40, -30, 600);
    const glm::vec3 now = place(viewpoint, 800, 600, held);
    EXPECT_NEAR(now.x, 40 / 400.0, 1e-3);
    EXPECT_NEAR(now.y, 30 / 300.0, 1e-3);
  }
}

TEST(Zoom, ComesCloserAndStaysInBounds) {
  Viewpoint viewpoint;
  const float before = viewpoint.half_height;
  zoom(viewpoint, 1);
  EXPECT_NEAR(viewpoint.half_height, before * 0.9F, 1e-4);
  zoom(viewpoint, 1000);
  EXPECT_FLOAT_EQ(viewpoint.half_height, 0.5F);
  zoom(viewpoint, -1000);
  EXPECT_FLOAT_EQ(viewpoint.half_height, 40);
}

}  // namespace
}  // namespace aucast::view
