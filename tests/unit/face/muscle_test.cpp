#include "client/face/muscle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "client/face/muscle_file.h"
#include "tests/support/displacement.h"
#include "tests/support/seeded.h"

namespace aucast::face {
namespace {

using aucast::test::displacement;
using aucast::test::Seeded;

constexpr float kRadPerDeg = std::numbers::pi_v<float> / 180;

LinearMuscle zygomatic() {
  return {{3.805F, 0.868F, 6.6F}, {1.57F, -2.221F, 7.82F}, 45 * kRadPerDeg, 0.1F, 4.8F, 0.95F};
}

MouthSphincter mouth() {
  return {{0, -2.35F, 8.2F}, {2.6F, 1.9F}, 3, 10};
}

EyeSphincter eye() {
  return {{2.2F, 2.72F, 7.2F}, {2.2F, 1.9F}, 2.5F, 30, 0.3F, 0.7F};
}

SheetMuscle sheet() {
  return {{2, 6.8F, 6.6F}, {2, 3.4F, 8}, 3.6F, 0.7F, 2};
}

LocalPull pull() {
  return {{0, -4.2F, 8.3F}, {0, 0.35F, 0.1F}, {1.2F, 0.9F, 1.5F}};
}

/// Every kind, so that what holds for all is tested on all.
std::vector<std::pair<std::string, MuscleShape>> all_kinds() {
  return {{"linear", zygomatic()},
          {"mouth", mouth()},
          {"eye", eye()},
          {"sheet", sheet()},
          {"pull", pull()}};
}

glm::vec3 random_point(Seeded& seeded) {
  return {static_cast<float>(seeded.real(-6, 6)), static_cast<float>(seeded.real(-8, 9)),
          static_cast<float>(seeded.real(3, 10))};
}

/// Where `at(t)` for t in [0,1] runs through space, the displacement may not jump: each step is at
/// most `slope` times the way of the point.
template <typename Path>
void expect_continuous(const MuscleShape& shape, Path at, float slope) {
  constexpr int kSteps = 20000;
  glm::vec3 point = at(0.0F);
  glm::vec3 moved = displacement(shape, point, 1);
  float total = glm::length(moved);
  for (int i = 1; i <= kSteps; ++i) {
    const glm::vec3 next = at(static_cast<float>(i) / kSteps);
    const glm::vec3 next_moved = displacement(shape, next, 1);
    ASSERT_LE(glm::distance(next_moved, moved), slope * glm::distance(next, point) + 2e-6F)
        << "at (" << next.x << ", " << next.y << ", " << next.z << ")";
    total += glm::length(next_moved);
    point = next;
    moved = next_moved;
  }
  EXPECT_GT(total, 0.0F) << "the path misses the muscle";
}

TEST(Muscle, ZeroActivationMovesNothing) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (const auto& [name, shape] : all_kinds()) {
    for (int run = 0; run < 1000; ++run) {
      ASSERT_EQ(displacement(shape, random_point(seeded), 0), glm::vec3(0)) << name;
    }
  }
}

TEST(Muscle, IsLinearInItsActivationUpToTheCap) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (const auto& [name, shape] : all_kinds()) {
    for (int run = 0; run < 1000; ++run) {
      const glm::vec3 point = random_point(seeded);
      const glm::vec3 one = displacement(shape, point, 1);
      const glm::vec3 half = displacement(shape, point, 0.5F);
      ASSERT_LT(glm::distance(one, 2.0F * half), 1e-6F) << name;
    }
  }
}

TEST(Muscle, MirrorsToTheOtherSide) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (const auto& [name, shape] : all_kinds()) {
    const MuscleShape other = mirrored(shape);
    EXPECT_EQ(x_of(other), -x_of(shape)) << name;
    for (int run = 0; run < 1000; ++run) {
      const glm::vec3 point = random_point(seeded);
      glm::vec3 expected = displacement(shape, point, 1.3F);
      expected.x = -expected.x;
      const glm::vec3 there = displacement(other, {-point.x, point.y, point.z}, 1.3F);
      ASSERT_LT(glm::distance(there, expected), 1e-6F) << name;
    }
  }
}

TEST(Muscle, StaysFiniteAtItsOwnSpecialPoints) {
  const LinearMuscle linear = zygomatic();
  EXPECT_EQ(displacement(linear, linear.attachment, 2), glm::vec3(0));
  EXPECT_EQ(displacement(mouth(), mouth().centre, 2), glm::vec3(0, 0, 0.2F));
  EXPECT_EQ(displacement(eye(), eye().centre, 2), glm::vec3(0, 0, 2.0F / 30));
  EXPECT_EQ(displacement(sheet(), sheet().attachment, 2), glm::vec3(0));
  EXPECT_EQ(displacement(pull(), pull().centre, 2), glm::vec3(0, 0.7F, 0.2F));
  const MouthSphincter round{{0, 0, 0}, {2, 2}, 3, 10};
  EXPECT_TRUE(std::isfinite(displacement(round, {1.9F, 0, 0}, 2).x));
  const SheetMuscle towards_viewer{{0, 0, 0}, {0, 0, 3}, 2, 0.7F, 2};
  EXPECT_LT(displacement(towards_viewer, {0, 0, 2}, 1).z, 0);
}

TEST(LinearMuscle, IsTheReleasedFormula) {
  // At the insertion: 44 hundredths of a unit per unit of activation.
  const glm::vec3 moved = displacement(zygomatic(), zygomatic().insertion, 1);
  EXPECT_NEAR(glm::length(moved), 0.44F, 0.01F);
  EXPECT_GT(moved.x, 0);
  EXPECT_GT(moved.y, 0);
  EXPECT_LT(moved.z, 0);
}

TEST(LinearMuscle, MovesNothingOutsideItsCone) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const LinearMuscle muscle = zygomatic();
  const glm::vec3 axis = glm::normalize(muscle.insertion - muscle.attachment);
  int outside = 0;
  for (int run = 0; run < 5000; ++run) {
    const glm::vec3 point = random_point(seeded);
    const glm::vec3 arm = point - muscle.attachment;
    const float angle = std::acos(glm::dot(glm::normalize(arm), axis));
    if (angle < muscle.zone_rad && glm::length(arm) < muscle.falloff_finish) continue;
    ++outside;
    ASSERT_EQ(displacement(muscle, point, 2), glm::vec3(0));
  }
  EXPECT_GT(outside, 1000);
}

TEST(LinearMuscle, IsContinuousAcrossZoneAndFalloff) {
  for (const float zone_deg : {35.0F, 45.0F, 65.0F}) {
    LinearMuscle muscle = zygomatic();
    muscle.zone_rad = zone_deg * kRadPerDeg;
    muscle.falloff_start = 1;
    const glm::vec3 axis = glm::normalize(muscle.insertion - muscle.attachment);
    const glm::vec3 across = glm::normalize(glm::cross(axis, glm::vec3(0, 0, 1)));
    expect_continuous(
        muscle, [&](float t) { return muscle.attachment + axis * (6 * t); }, 6);
    expect_continuous(
        muscle, [&](float t) { return muscle.attachment + axis * 2.0F + across * (12 * t - 6); },
        6);
  }
}

TEST(LinearMuscle, NeverFoldsTheSkinAlongItsAxis) {
  for (const float zone_deg : {20.0F, 35.0F, 45.0F, 65.0F, 80.0F}) {
    LinearMuscle muscle = zygomatic();
    muscle.zone_rad = zone_deg * kRadPerDeg;
    const glm::vec3 axis = glm::normalize(muscle.insertion - muscle.attachment);
    for (float activation = 0; activation <= 2; activation += 0.25F) {
      float before = -1;
      for (float distance = 0.001F; distance < 6; distance += 0.01F) {
        const glm::vec3 point = muscle.attachment + axis * distance;
        const glm::vec3 moved = point + displacement(muscle, point, activation);
        const float along = glm::dot(moved - muscle.attachment, axis);
        ASSERT_GT(along, before) << zone_deg << " degrees, activation " << activation;
        before = along;
      }
    }
  }
}

TEST(LinearMuscle, TheCapIsAShareOfTheWayToTheAttachment) {
  LinearMuscle muscle = zygomatic();
  muscle.zone_rad = 65 * kRadPerDeg;
  muscle.falloff_start = 4;
  const glm::vec3 axis = glm::normalize(muscle.insertion - muscle.attachment);
  const glm::vec3 point = muscle.attachment + 3.0F * axis;
  EXPECT_NEAR(glm::length(displacement(muscle, point, 2)), 0.95F * 3, 1e-5F);
  EXPECT_EQ(displacement(muscle, point, 2), displacement(muscle, point, 0.8F));
  muscle.cap.reset();
  const float gain = 1 / std::cos(muscle.zone_rad) - 1;
  EXPECT_NEAR(glm::length(displacement(muscle, point, 4)), 4 * gain * 3, 1e-4F);
  EXPECT_EQ(influence(muscle, point).activation_cap, std::numeric_limits<float>::infinity());
}

TEST(MouthSphincter, KeepsTheMidlineAndDrawsTheCornersIn) {
  const MouthSphincter muscle = mouth();
  const glm::vec3 inner = muscle.centre + glm::vec3(1.0F, 0.5F, 0);
  EXPECT_EQ(displacement(muscle, inner, 2).x, 0);
  EXPECT_GT(displacement(muscle, inner, 2).z, 0);
  const glm::vec3 corner = muscle.centre + glm::vec3(2.2F, 0, 0);
  EXPECT_LT(displacement(muscle, corner, 1).x, 0);
  EXPECT_EQ(displacement(muscle, corner, 1).y, 0);
  EXPECT_EQ(displacement(muscle, muscle.centre + glm::vec3(2.6F, 0, 0), 2), glm::vec3(0));
  EXPECT_EQ(displacement(muscle, muscle.centre + glm::vec3(0, 0, -3), 2), glm::vec3(0));
}

TEST(MouthSphincter, IsContinuousAtRimHoleAndDepth) {
  const MouthSphincter muscle = mouth();
  expect_continuous(
      muscle, [&](float t) { return muscle.centre + glm::vec3(6 * t - 3, 0.1F, 0); }, 3);
  expect_continuous(
      muscle, [&](float t) { return muscle.centre + glm::vec3(0.1F, 6 * t - 3, 0); }, 3);
  expect_continuous(
      muscle, [&](float t) { return muscle.centre + glm::vec3(2.2F, 0, 8 * t - 4); }, 3);
}

TEST(MouthSphincter, NeverFoldsTheSkinAlongItsLongAxis) {
  const MouthSphincter muscle = mouth();
  for (float activation = 0; activation <= 2; activation += 0.25F) {
    float before = -1;
    for (float x = 0; x < 3; x += 0.005F) {
      const float moved =
          x + displacement(muscle, muscle.centre + glm::vec3(x, 0, 0), activation).x;
      ASSERT_GT(moved, before) << "activation " << activation << " at " << x;
      before = moved;
    }
  }
}

TEST(EyeSphincter, LiftsTheLowerSideMore) {
  const EyeSphincter muscle = eye();
  const float upper = displacement(muscle, muscle.centre + glm::vec3(0, 0.8F, 0), 1).y;
  const float lower = displacement(muscle, muscle.centre - glm::vec3(0, 0.8F, 0), 1).y;
  EXPECT_LT(upper, 0);
  EXPECT_GT(lower, 0);
  EXPECT_NEAR(lower / -upper, 0.7F / 0.3F, 1e-4F);
  EXPECT_EQ(displacement(muscle, muscle.centre + glm::vec3(2.2F, 0, 0), 2), glm::vec3(0));
}

TEST(EyeSphincter, IsContinuousAtRimAxisAndDepth) {
  const EyeSphincter muscle = eye();
  expect_continuous(
      muscle, [&](float t) { return muscle.centre + glm::vec3(6 * t - 3, 0.3F, 0); }, 3);
  expect_continuous(
      muscle, [&](float t) { return muscle.centre + glm::vec3(0.5F, 6 * t - 3, 0); }, 3);
  expect_continuous(
      muscle, [&](float t) { return muscle.centre + glm::vec3(0, 0.8F, 8 * t - 4); }, 3);
}

TEST(EyeSphincter, NeverFoldsAndNeverCrossesItsAxis) {
  EyeSphincter muscle = eye();
  muscle.upper_share = muscle.lower_share = 1;
  for (float activation = 0; activation <= 2; activation += 0.25F) {
    float before = -2;
    for (float y = -1.9F; y < 2; y += 0.005F) {
      const float moved =
          y + displacement(muscle, muscle.centre + glm::vec3(0, y, 0), activation).y;
      ASSERT_GE(moved, before) << "activation " << activation << " at " << y;
      ASSERT_GE(moved * y, -1e-6F);
      before = moved;
    }
  }
}

TEST(SheetMuscle, PullsTheStripTowardsTheBoneMostAtItsPeak) {
  const SheetMuscle muscle = sheet();
  const glm::vec3 span = muscle.insertion - muscle.attachment;
  const auto at = [&](float share) {
    return glm::length(displacement(muscle, muscle.attachment + share * span, 1));
  };
  EXPECT_NEAR(at(0.7F), 0.7F * glm::length(span) / std::numbers::pi_v<float>, 1e-5F);
  EXPECT_GT(at(0.7F), at(0.6F));
  EXPECT_GT(at(0.7F), at(0.8F));
  EXPECT_NEAR(at(1.0F), 0.0F, 1e-6F);
  EXPECT_GT(displacement(muscle, muscle.attachment + 0.7F * span, 1).y, 0);
}

TEST(SheetMuscle, IsContinuousAtAllEdges) {
  const SheetMuscle muscle = sheet();
  const glm::vec3 span = muscle.insertion - muscle.attachment;
  const glm::vec3 middle = muscle.attachment + 0.7F * span;
  expect_continuous(
      muscle, [&](float t) { return muscle.attachment + (1.4F * t - 0.2F) * span; }, 3);
  expect_continuous(
      muscle, [&](float t) { return middle + glm::vec3(6 * t - 3, 0, 0); }, 3);
  expect_continuous(
      muscle, [&](float t) { return middle + glm::vec3(0, 0, 6 * t - 3); }, 3);
}

TEST(SheetMuscle, NeverFoldsTheSkinAlongItsAxis) {
  for (const float peak : {0.3F, 0.5F, 0.7F, 0.9F}) {
    SheetMuscle muscle = sheet();
    muscle.peak = peak;
    const glm::vec3 span = muscle.insertion - muscle.attachment;
    for (float activation = 0; activation <= 2; activation += 0.25F) {
      float before = -1;
      for (float share = 0; share < 1.2F; share += 0.002F) {
        const glm::vec3 point = muscle.attachment + share * span;
        const glm::vec3 moved = point + displacement(muscle, point, activation);
        const float along = glm::dot(moved - muscle.attachment, span);
        ASSERT_GT(along, before - 1e-5F) << "peak " << peak << ", activation " << activation;
        before = along;
      }
    }
  }
}

TEST(LocalPull, FallsOffByItsRadiiAndEndsAtThree) {
  const LocalPull muscle = pull();
  const auto up = [&](const glm::vec3& shift) {
    return displacement(muscle, muscle.centre + shift, 1).y;
  };
  EXPECT_NEAR(up({0, 0, 0}), 0.35F, 1e-6F);
  EXPECT_NEAR(up({1.2F, 0, 0}), 0.35F * std::exp(-1.0F), 1e-4F);
  EXPECT_NEAR(up({0, 0.9F, 0}), 0.35F * std::exp(-1.0F), 1e-4F);
  EXPECT_EQ(up({3.61F, 0, 0}), 0.0F);
  expect_continuous(
      muscle, [&](float t) { return muscle.centre + glm::vec3(10 * t - 5, 0, 0); }, 1);
}

TEST(LocalPull, NeverFoldsWhileItsDirectionIsShortAgainstItsRadii) {
  const LocalPull muscle{{0, 0, 0}, {0, 0.57F, 0}, {1, 1, 1}};
  float before = -10;
  for (float y = -4; y < 4; y += 0.002F) {
    const float moved = y + displacement(muscle, {0, y, 0}, 2).y;
    ASSERT_GT(moved, before) << y;
    before = moved;
  }
}

}  // namespace
}  // namespace aucast::face
