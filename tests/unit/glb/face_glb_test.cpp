#include "client/glb/face_glb.h"

#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/face/small_face.h"

namespace aucast::glb {
namespace {

using face::test::small_face;

Json document_of(const std::string& bytes) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return Json::parse(bytes.substr(20, length));
}

About about() {
  return {"a licence", "talk.wav", {{{"mouthSmileLeft", 12, Side::Left, 1}}}};
}

class FaceGlb : public testing::TestWithParam<Basis> {
 protected:
  FaceGlb()
      : face_(small_face()),
        rig_(face_, GetParam() == Basis::Muscles),
        targets_(face_, GetParam(), rig_) {}

  [[nodiscard]] Motion motion() const {
    Motion motion;
    motion.name = "talk";
    std::vector<float> activations(face_.channels.size());
    activations[*face_.channel_index("head_turn_left")] = 1;
    for (const float seconds : {0.0F, 0.5F}) {
      motion.seconds.push_back(seconds);
      motion.weights.resize(motion.weights.size() + targets_.all().size());
      motion.joints.push_back(rig_.pose(activations));
    }
    return motion;
  }

  face::Face face_;
  FaceRig rig_;
  MorphTargets targets_;
};

TEST_P(FaceGlb, EveryMorphingMeshHasAllTargetsAndTheirNames) {
  const Json document = document_of(*face_glb(face_, targets_, rig_, nullptr, about()));
  std::size_t morphing = 0;
  for (const Json& mesh : document["meshes"]) {
    const Json& primitive = mesh["primitives"][0];
    if (!primitive.contains("targets")) continue;
    ++morphing;
    EXPECT_EQ(primitive["targets"].size(), targets_.all().size());
    EXPECT_EQ(mesh["extras"]["targetNames"].size(), targets_.all().size());
    EXPECT_EQ(mesh["weights"].size(), targets_.all().size());
    EXPECT_EQ(mesh["extras"]["targetNames"][0], targets_.all()[0].name);
  }
  EXPECT_EQ(morphing, 1U) << "the skin; eyeballs turn as nodes";
  EXPECT_FALSE(document.contains("animations"));
}

TEST_P(FaceGlb, EveryNodeHasOnePlace) {
  const Json document = document_of(*face_glb(face_, targets_, rig_, nullptr, about()));
  std::multiset<int> placed;
  for (const Json& node : document["scenes"][0]["nodes"]) placed.insert(node.get<int>());
  for (const Json& node : document["nodes"]) {
    for (const Json& child : node.value("children", Json::array())) placed.insert(child.get<int>());
  }
  ASSERT_EQ(placed.size(), document["nodes"].size());
  int next = 0;
  for (const int node : placed) EXPECT_EQ(node, next++);
}

TEST_P(FaceGlb, TheAnimationMovesWeightsAndTheJointsThatMove) {
  const Motion talk = motion();
  const Json document = document_of(*face_glb(face_, targets_, rig_, &talk, about()));
  const Json& animation = document["animations"][0];
  EXPECT_EQ(animation["name"], "talk");
  std::set<std::string> moved;
  for (const Json& channel : animation["channels"]) {
    const Json& node = document["nodes"][channel["target"]["node"].get<std::size_t>()];
    moved.insert(node["name"].get<std::string>() + "." +
                 channel["target"]["path"].get<std::string>());
  }
  EXPECT_EQ(moved, (std::set<std::string>{"skin.weights", "head.rotation", "neck.rotation"}));
}

TEST_P(FaceGlb, SaysWhatItIs) {
  const Json document = document_of(*face_glb(face_, targets_, rig_, nullptr, about()));
  EXPECT_EQ(document["asset"]["copyright"], "a licence");
  EXPECT_EQ(document["extensionsRequired"], Json{"KHR_mesh_quantization"});
  const Json& notes = document["scenes"][0]["extras"]["aucast"];
  EXPECT_EQ(notes["sound"]["file"], "talk.wav");
  ASSERT_TRUE(notes["arkit52"].contains("mouthSmileLeft"));
  const Json& smile = notes["arkit52"]["mouthSmileLeft"]["targets"];
  ASSERT_FALSE(smile.empty());
  for (const auto& [name, weight] : smile.items()) {
    EXPECT_EQ(name.find(GetParam() == Basis::Aus ? "_R" : "right_"), std::string::npos) << name;
    EXPECT_GT(weight.get<double>(), 0);
  }
  bool smiles = false;
  for (const Json& au : notes["actionUnits"]) {
    smiles = smiles || (au["number"] == 12 && au["name"] == "Lip Corner Puller");
  }
  EXPECT_TRUE(smiles);
}

TEST_P(FaceGlb, TheSameFaceGivesTheSameBytes) {
  const Motion talk = motion();
  const auto first = face_glb(face_, targets_, rig_, &talk, about());
  const MorphTargets again(face_, GetParam(), rig_);
  EXPECT_EQ(*first, *face_glb(face_, again, rig_, &talk, about()));
}

INSTANTIATE_TEST_SUITE_P(Bases, FaceGlb, testing::Values(Basis::Muscles, Basis::Aus));

}  // namespace
}  // namespace aucast::glb
