#include "client/glb/morph_targets.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/face/face_deformer.h"
#include "client/glb/units.h"
#include "tests/unit/face/small_face.h"

namespace aucast::glb {
namespace {

using face::test::small_face;

const Target* named(const MorphTargets& targets, std::string_view name) {
  const auto found = std::find_if(targets.all().begin(), targets.all().end(),
                                  [&](const Target& target) { return target.name == name; });
  return found == targets.all().end() ? nullptr : &*found;
}

TEST(MorphTargets, AtWeightOneAMuscleIsAtItsLargestContraction) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  const MorphTargets targets(face, Basis::Muscles, rig);
  ASSERT_FALSE(targets.all().empty());
  face::FaceDeformer deformer(face);
  for (const Target& target : targets.all()) {
    if (target.arc || target.name == "jaw") continue;
    std::vector<glm::vec3> positions = face.mesh.positions;
    for (const Change& change : target.positions) positions[change.vertex] += glm::vec3(change.by);
    const auto& real = deformer.deform(target.pose).positions;
    for (const face::MeshPart& part : face.mesh.parts) {
      if (part.material != face::Material::Skin) continue;
      for (std::uint32_t i = part.vertex_begin; i < part.vertex_begin + part.vertex_count; ++i) {
        ASSERT_LT(glm::distance(positions[i], real[i]), 0.004F) << target.name;
      }
    }
    EXPECT_EQ(target.pose[target.channel], face.channels[target.channel].activation_max);
  }
}

TEST(MorphTargets, AMuscleTurnsNormalsHoweverTheJointsPlacesAreRounded) {
  face::Face face = small_face();
  ASSERT_TRUE(face.head.has_value());
  ASSERT_FALSE(face.eyes.empty());
  face.head->pivot += glm::vec3(0.1F, -1.7F, -3.3F);
  face.eyes.front().centre += glm::vec3(1e-3F, 0.7F, 0.9F);
  const FaceRig rig(face, true);
  const MorphTargets targets(face, Basis::Muscles, rig);
  face::FaceDeformer deformer(face);
  const std::vector<glm::vec3> rest =
      deformer.deform(std::vector<float>(face.channels.size())).normals;
  std::size_t turned = 0;
  for (const Target& target : targets.all()) {
    if (target.arc || target.name == "jaw") continue;
    const auto& real = deformer.deform(target.pose).normals;
    for (const Change& change : target.normals) {
      ++turned;
      const glm::vec3 own = rest[change.vertex] + glm::vec3(change.by);
      EXPECT_LT(glm::distance(own, real[change.vertex]), 1e-3F) << target.name;
    }
  }
  EXPECT_GT(turned, 0U);
}

TEST(MorphTargets, WhatJointsDoIsNoTarget) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  const MorphTargets muscles(face, Basis::Muscles, rig);
  EXPECT_EQ(named(muscles, "head_up"), nullptr);
  const MorphTargets aus(face, Basis::Aus, FaceRig(face, false));
  for (const Target& target : aus.all()) EXPECT_EQ(target.name.substr(0, 2), "AU");
}

TEST(MorphTargets, ALidsArcIsNothingAtItsEndsAndWholeHalfWay) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  const MorphTargets targets(face, Basis::Muscles, rig);
  const Target* const arc = named(targets, "left_lid_close_arc");
  ASSERT_NE(arc, nullptr);
  EXPECT_FALSE(arc->positions.empty());
  EXPECT_EQ(arc->weight(0), 0);
  EXPECT_EQ(arc->weight(0.5F), 1);
  EXPECT_EQ(arc->weight(1), 0);
  const MorphTargets aus(face, Basis::Aus, FaceRig(face, false));
  for (const Target& target : aus.all()) EXPECT_FALSE(target.arc);
}

TEST(MorphTargets, BothSidesOfAnAuTogetherAreTheAu) {
  const face::Face face = small_face();
  for (const auto& [number, recording] : face.recordings) {
    if (number == 0 || shows_on_one_side(number)) continue;
    const std::vector<float> left = side_of_au(face, number, Side::Left);
    const std::vector<float> right = side_of_au(face, number, Side::Right);
    for (std::size_t i = 0; i < left.size(); ++i) {
      EXPECT_FLOAT_EQ(left[i] + right[i], recording.activation[i]) << number;
    }
  }
}

TEST(MorphTargets, WeightsAreSharesOfTheLargestContractionOrIntensities) {
  const face::Face face = small_face();
  const FaceRig rig(face, false);
  const MorphTargets muscles(face, Basis::Muscles, rig);
  pipeline::FaceState state{{}, std::vector<float>(face.channels.size())};
  const Target& first = muscles.all().front();
  state.activations[first.channel] = face.channels[first.channel].activation_max / 2;
  EXPECT_EQ(muscles.weights(face, state).front(), 128);
  state.activations[first.channel] = 100;
  EXPECT_EQ(muscles.weights(face, state).front(), 255);

  const MorphTargets aus(face, Basis::Aus, rig);
  ASSERT_GE(aus.all().size(), 2U);
  const Target& left = aus.all()[0];
  ASSERT_EQ(left.side, Side::Left);
  state.aus.left[static_cast<std::size_t>(left.au)] = 0.2F;
  EXPECT_EQ(aus.weights(face, state)[0], 51);
  EXPECT_EQ(aus.weights(face, state)[1], 0);
}

TEST(MorphTargets, VerticesAscendAndMoveByWholeStepsOfTheFile) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  for (const Basis basis : {Basis::Muscles, Basis::Aus}) {
    const MorphTargets targets(face, basis, rig);
    for (const Target& target : targets.all()) {
      for (const auto& changes : {target.positions, target.normals}) {
        EXPECT_TRUE(
            std::is_sorted(changes.begin(), changes.end(),
                           [](const Change& a, const Change& b) { return a.vertex < b.vertex; }))
            << target.name;
      }
      for (const Change& change : target.positions) {
        const glm::vec3 metres = kMetresPerUnit * glm::vec3(change.by);
        ASSERT_LT(glm::distance(stored_position_change(metres), metres), 1e-6F) << target.name;
      }
    }
  }
}

TEST(MorphTargets, HairClothesAndEyeballsNeverMove) {
  face::Face face = small_face();
  // The lower half of the skin becomes a beard, which would go with the mouth.
  face::MeshPart beard = face.mesh.parts.front();
  beard.vertex_count /= 2;
  beard.material = face::Material::Hair;
  face.mesh.parts.push_back(beard);
  const MorphTargets targets(face, Basis::Muscles, FaceRig(face, true));
  EXPECT_FALSE(targets.all().empty());
  for (const Target& target : targets.all()) {
    for (const Change& change : target.positions) {
      ASSERT_GE(change.vertex, beard.vertex_count) << target.name;
      ASSERT_LT(change.vertex, face.mesh.parts[1].vertex_begin) << target.name;
    }
  }
}

TEST(MorphTargets, WhatMovesNothingIsLeftOut) {
  face::Face face = small_face();
  face.recordings[90] = {90, std::vector<float>(face.channels.size()), "nothing"};
  const MorphTargets aus(face, Basis::Aus, FaceRig(face, false));
  EXPECT_EQ(named(aus, "AU90_L"), nullptr);
  EXPECT_NE(named(aus, "AU12_L"), nullptr);
  EXPECT_EQ(named(aus, "AU51_L"), nullptr) << "the head's joints do it";
}

TEST(MorphTargets, OnesideOfASmileMovesThatSideAndTheWinkItsLid) {
  const face::Face face = small_face();
  const MorphTargets aus(face, Basis::Aus, FaceRig(face, false));
  for (const auto& [name, sign] :
       {std::pair{"AU12_L", 1.0F}, {"AU46_L", 1.0F}, {"AU12_R", -1.0F}, {"AU46_R", -1.0F}}) {
    const Target* const target = named(aus, name);
    ASSERT_NE(target, nullptr) << name;
    ASSERT_FALSE(target->positions.empty()) << name;
    float most = 0;
    float there = 0;
    for (const Change& change : target->positions) {
      const float way = glm::length(glm::vec3(change.by));
      if (way > most) there = face.mesh.positions[change.vertex].x;
      most = std::max(most, way);
    }
    EXPECT_GT(sign * there, 0) << name << " moves most at x " << there;
  }
}

TEST(MorphTargets, WhereItIsAJointTheJawHasLittleLeftToDo) {
  const face::Face face = small_face();
  const std::vector<float>& head = *face::find_map(face.mesh, "head");
  const auto moved_by_jaw = [&](bool joint) {
    const MorphTargets targets(face, Basis::Muscles, FaceRig(face, joint));
    const Target* const jaw = named(targets, "jaw");
    float most = 0;
    for (const Change& change : jaw == nullptr ? std::vector<Change>() : jaw->positions) {
      // Where the neck bends as well, the target has more to do.
      if (head[change.vertex] < 1) continue;
      most = std::max(most, glm::length(glm::vec3(change.by)));
    }
    return most;
  };
  EXPECT_GT(moved_by_jaw(false), 0.5F);
  EXPECT_LT(moved_by_jaw(true), 0.1F * moved_by_jaw(false));
}

TEST(MorphTargets, HalfWayATargetAndItsArcAreTheLidHalfClosed) {
  const face::Face face = small_face();
  const MorphTargets targets(face, Basis::Muscles, FaceRig(face, true));
  const Target* const lid = named(targets, "left_lid_close");
  const Target* const arc = named(targets, "left_lid_close_arc");
  ASSERT_NE(lid, nullptr);
  ASSERT_NE(arc, nullptr);
  face::FaceDeformer deformer(face);
  const auto& real = deformer.deform(face::test::only(face, "left_lid_close", 0.5F)).positions;
  std::vector<glm::vec3> positions = face.mesh.positions;
  for (const Change& change : lid->positions)
    positions[change.vertex] += 0.5F * glm::vec3(change.by);
  for (const Change& change : arc->positions) positions[change.vertex] += glm::vec3(change.by);
  float worst = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    worst = std::max(worst, glm::distance(positions[i], real[i]));
  }
  EXPECT_LT(worst, 0.01F) << "mesh units";
}

}  // namespace
}  // namespace aucast::glb
