#include "client/glb/face_rig.h"

#include <gtest/gtest.h>

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
    const glm::vec3 place(carriers[*joint] * glm::vec4(face.mesh.positions[i], 1));
    worst = std::max(worst, glm::distance(place, real[i]));
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

TEST(FaceRig, SharesSumToOneAndNameJointsThatAreThere) {
  const face::Face face = small_face();
  for (const bool with_jaw : {true, false}) {
    const FaceRig rig(face, with_jaw);
    for (std::size_t i = 0; i < face.mesh.positions.size(); ++i) {
      const Carried carried = rig.carried(i);
      float sum = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += carried.shares[k];
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

}  // namespace
}  // namespace aucast::glb
