// What must hold for the face that the programs show, whatever its shape and calibration are.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "client/face/co_occurrence_rules.h"
#include "client/face/face_deformer.h"
#include "client/face/muscle_mixer.h"
#include "tests/unit/face/shipped_data.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

using test::kData;

class DefaultFace : public ::testing::Test {
 protected:
  void SetUp() override {
    auto loaded = load_face(kData / "faces" / "default", kData);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    face_ = *std::move(loaded);
  }
  [[nodiscard]] std::vector<float> activations_of(int number, float left, float right) const {
    AuFrame frame;
    frame.left[static_cast<std::size_t>(number)] = left;
    frame.right[static_cast<std::size_t>(number)] = right;
    std::vector<float> activations(face_.channels.size());
    mix(face_, frame, Mixer::Maximum, activations);
    return activations;
  }

  Face face_;
};

TEST_F(DefaultFace, HasEveryMoverAndNoRemark) {
  EXPECT_TRUE(face_.jaw.has_value());
  EXPECT_TRUE(face_.lids.has_value());
  EXPECT_TRUE(face_.head.has_value());
  EXPECT_TRUE(face_.hair.has_value());
  EXPECT_EQ(face_.eyes.size(), 2U);
  EXPECT_TRUE(face_.remarks.empty());
}

TEST_F(DefaultFace, PlaysTheActionUnitsOfTheThesis) {
  for (const int number : {1,  2,  4,  5,  6,  7,  9,  10, 12, 13, 14, 15, 16, 17, 20, 23,
                           25, 26, 43, 45, 46, 51, 52, 53, 54, 55, 56, 61, 62, 63, 64}) {
    ASSERT_TRUE(face_.recordings.contains(number)) << "AU" << number;
    const auto activations = activations_of(number, 1, 1);
    EXPECT_GT(*std::max_element(activations.begin(), activations.end()), 0) << "AU" << number;
  }
}

TEST_F(DefaultFace, EveryChannelMovesTheFaceAndKeepsItFinite) {
  FaceDeformer deformer(face_);
  for (const Channel& channel : face_.channels) {
    const DeformedFace& out =
        deformer.deform(test::only(face_, channel.name, channel.activation_max));
    const bool draws_lines =
        std::any_of(out.creases.begin(), out.creases.end(), [](float depth) { return depth > 0; });
    EXPECT_NE(out.positions != face_.mesh.positions, draws_lines) << channel.name;
    for (std::size_t i = 0; i < out.positions.size(); ++i) {
      const glm::vec3& p = out.positions[i];
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
          << channel.name << ", vertex " << i;
      ASSERT_NEAR(glm::length(out.normals[i]), 1, 1e-4F) << channel.name << ", vertex " << i;
    }
  }
}

TEST_F(DefaultFace, ZeroIsTheNeutralFaceBitForBit) {
  FaceDeformer deformer(face_);
  const DeformedFace& out = deformer.deform(std::vector<float>(face_.channels.size(), 0.0F));
  EXPECT_EQ(out.positions, face_.mesh.positions);
}

TEST_F(DefaultFace, LeftMusclesHaveARightTwin) {
  for (const Channel& channel : face_.channels) {
    if (channel.side != Side::Left || !channel.name.starts_with("left_")) continue;
    EXPECT_TRUE(face_.channel_index("right_" + channel.name.substr(5)).has_value()) << channel.name;
  }
}

TEST_F(DefaultFace, OneSideOfASmileStaysOnItsSide) {
  FaceDeformer deformer(face_);
  const std::vector<glm::vec3>& out = deformer.deform(activations_of(12, 1, 0)).positions;
  float left = 0;
  float right = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    float& side = face_.mesh.positions[i].x > 0 ? left : right;
    side = std::max(side, glm::distance(out[i], face_.mesh.positions[i]));
  }
  EXPECT_GT(left, 0.2F);
  EXPECT_LT(right, 0.5F * left);
}

}  // namespace
}  // namespace aucast::face
