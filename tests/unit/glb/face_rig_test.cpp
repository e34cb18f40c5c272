#include "client/glb/face_rig.h"

#include <cmath>
#include <string_view>

#include <gtest/gtest.h>
#include <glm/trigonometric.hpp>

#include "client/face/face_deformer.h"
#include "tests/unit/face/small_face.h"

namespace aucast::glb {
namespace {

using face::test::only;
using face::test::small_face;

/// How far the joints leave a vertex from where the deformer has it, for the worst that one joint
/// carries wholly.
float worst_carried(const face::Face& face, std::vector<float> activations) {
  const FaceRig rig(face, true);
  face::FaceDeformer deformer(face);
  const std::vector<glm::vec3>& real = deformer.deform(activations).positions;
  const std::vector<glm::mat4> carriers = rig.carriers(rig.pose(activations));
  float worst = 0;
  std::size_t wholly = 0;
  for (std::size_t i = 0; i < real.size(); ++i) {
    const auto joint = rig.carried(i).wholly();
    // Of the jaw, what bends with the neck as well is a target's.
    const bool throat = face::map_at(face::find_map(face.mesh, "jaw"), i, 0) > 0 &&
                        face::map_at(face::find_map(face.mesh, "head"), i, 0) < 1;
    if (!joint || throat) continue;
    if (*joint != 0) ++wholly;
    const glm::vec3 position(carriers[*joint] * glm::vec4(face.mesh.positions[i], 1));
    worst = std::max(worst, glm::distance(position, real[i]));
  }
  EXPECT_GT(wholly, 0U);
  return worst;
}

TEST(FaceRig, CarriesWhatTurnsWhollyAsTheDeformerDoes) {
  const face::Face face = small_face();
  for (const char* channel :
       {"head_turn_left", "head_turn_right", "head_up", "head_down", "head_tilt_left",
        "head_forward", "head_back", "jaw", "left_gaze_left", "right_gaze_up", "left_gaze_down"}) {
    if (!face.channel_index(channel)) continue;
    EXPECT_LT(worst_carried(face, only(face, channel, 1)), 1e-4F) << channel;
  }
  std::vector<float> all = only(face, "head_turn_left", 0.7F);
  all[*face.channel_index("head_down")] = 0.5F;
  all[*face.channel_index("head_tilt_right")] = 0.9F;
  all[*face.channel_index("jaw")] = 2;
  all[*face.channel_index("left_gaze_up")] = 0.6F;
  EXPECT_LT(worst_carried(face, all), 1e-4F);
}

TEST(FaceRig, WeightsSumToOneAndNameJointsThatAreThere) {
  const face::Face face = small_face();
  for (const bool with_jaw : {true, false}) {
    const FaceRig rig(face, with_jaw);
    for (std::size_t i = 0; i < face.mesh.positions.size(); ++i) {
      const Carried carried = rig.carried(i);
      float sum = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += carried.weights[k];
        EXPECT_LT(carried.joints[k], rig.joints().size());
      }
      EXPECT_NEAR(sum, 1, 1e-5F);
    }
  }
}

TEST(FaceRig, WithoutItTheJawIsNoJoint) {
  const face::Face face = small_face();
  const std::size_t jaw = *face.channel_index("jaw");
  EXPECT_TRUE(FaceRig(face, true).takes(jaw));
  EXPECT_FALSE(FaceRig(face, false).takes(jaw));
  EXPECT_FALSE(FaceRig(face, true).takes(0)) << "a muscle";
  const FaceRig without(face, false);
  for (const Joint& joint : without.joints()) EXPECT_NE(joint.name, "jaw");
}

TEST(FaceRig, AtRestNothingIsCarriedAway) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  for (const glm::mat4& carrier :
       rig.carriers(rig.pose(std::vector<float>(face.channels.size())))) {
    EXPECT_LT(glm::distance(glm::vec3(carrier * glm::vec4(1, 2, 3, 1)), glm::vec3(1, 2, 3)), 1e-5F);
  }
}

/// The joint of this name; a failure, and 0, if there is none.
std::size_t joint_named(const FaceRig& rig, std::string_view name) {
  for (std::size_t i = 0; i < rig.joints().size(); ++i) {
    if (rig.joints()[i].name == name) return i;
  }
  ADD_FAILURE() << "no joint " << name;
  return 0;
}

TEST(FaceRig, AJointsPositionIsItsParentsAndTheWayFromThere) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  for (std::size_t i = 0; i < rig.joints().size(); ++i) {
    glm::vec3 position(0);
    for (std::size_t at = i; at != 0; at = rig.joints()[at].parent) position += rig.from_parent(at);
    EXPECT_LT(glm::distance(position, rig.joints()[i].position), 1e-6F) << rig.joints()[i].name;
    EXPECT_LE(rig.joints()[i].parent, i) << "a parent comes first";
  }
  EXPECT_EQ(rig.joints()[joint_named(rig, "jaw")].position, face.jaw->hinge);
  EXPECT_EQ(rig.joints()[joint_named(rig, "head")].parent, joint_named(rig, "neck"));
  for (const char* part : {"jaw", "left_eye", "right_eye"}) {
    EXPECT_EQ(rig.joints()[joint_named(rig, part)].parent, joint_named(rig, "head")) << part;
  }
}

TEST(FaceRig, WithoutAHeadTheRestHangsOnTheBody) {
  face::Face face = small_face();
  face.head.reset();
  const FaceRig rig(face, true);
  EXPECT_EQ(rig.joints().size(), 4U) << "body, jaw and eyes";
  EXPECT_EQ(rig.joints()[joint_named(rig, "left_eye")].parent, 0U);
  EXPECT_FALSE(rig.takes(*face.channel_index("head_up")));
  for (std::size_t i = 0; i < face.mesh.positions.size(); i += 100) {
    const Carried carried = rig.carried(i);
    EXPECT_FLOAT_EQ(carried.weights[0] + carried.weights[1], 1) << "of the jaw and the body";
    EXPECT_EQ(carried.weights[2], 0);
  }
}

TEST(FaceRig, NeckAndHeadTogetherTurnAsTheHeadIsAsked) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  std::vector<float> activations = only(face, "head_turn_left", 1);
  activations[*face.channel_index("head_up")] = 0.5F;
  const auto poses = rig.pose(activations);
  const glm::quat whole =
      poses[joint_named(rig, "neck")].rotation * poses[joint_named(rig, "head")].rotation;
  // What is in front goes up first, then to the left.
  const glm::vec3 ahead = whole * glm::vec3(0, 0, 1);
  const float up = glm::radians(face.head->pitch_deg / 2);
  const float left = glm::radians(face.head->turn_deg);
  EXPECT_NEAR(ahead.y, std::sin(up), 1e-5F);
  EXPECT_NEAR(ahead.x, std::cos(up) * std::sin(left), 1e-5F);
  EXPECT_GT(ahead.z, 0);
  EXPECT_FALSE(poses[joint_named(rig, "jaw")].moved());
}

TEST(FaceRig, EachEyeFollowsItsOwnChannelsAndOppositesCancel) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  std::vector<float> activations = only(face, "left_gaze_left", 1);
  activations[*face.channel_index("right_gaze_up")] = 1;
  activations[*face.channel_index("right_gaze_down")] = 1;
  const auto poses = rig.pose(activations);
  EXPECT_TRUE(poses[joint_named(rig, "left_eye")].moved());
  EXPECT_FALSE(poses[joint_named(rig, "right_eye")].moved());
  const glm::vec3 ahead = poses[joint_named(rig, "left_eye")].rotation * glm::vec3(0, 0, 1);
  EXPECT_NEAR(ahead.x, std::sin(glm::radians(face.eyes.front().yaw_deg)), 1e-5F);
}

TEST(FaceRig, AnEyeballIsCarriedByItsJointAlone) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  for (const std::size_t part : {1U, 2U}) {
    const face::MeshPart& eye = face.mesh.parts[part];
    for (std::uint32_t i = 0; i < eye.vertex_count; ++i) {
      EXPECT_EQ(rig.carried(eye.vertex_begin + i).wholly(), joint_named(rig, eye.name));
    }
  }
  EXPECT_FALSE((Carried{{0, 1, 0, 0}, {0.5F, 0.5F, 0, 0}}).wholly().has_value());
}

}  // namespace
}  // namespace aucast::glb
