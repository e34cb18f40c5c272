#include "client/glb/face_notes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/face/small_face.h"

namespace aucast::glb {
namespace {

using face::test::small_face;

/// The notes of a face, and what they are about.
struct Noted {
  explicit Noted(Basis basis, const About& about = {}, face::Face of = small_face())
      : face(std::move(of)),
        rig(face, basis == Basis::Muscles),
        targets(face, basis, rig),
        notes(face_notes(face, targets, rig, about)) {}

  /// The row of an Action Unit; a failure, and nothing, if there is none.
  [[nodiscard]] Json au(int number) const {
    for (const Json& one : notes["actionUnits"]) {
      if (one["number"] == number) return one;
    }
    ADD_FAILURE() << "no AU " << number;
    return Json::object();
  }

  face::Face face;
  FaceRig rig;
  MorphTargets targets;
  Json notes;
};

TEST(FaceNotes, AnActionUnitIsMadeOfSharesOfItsMuscles) {
  const Noted noted(Basis::Muscles);
  const Json smile = noted.au(12);
  EXPECT_EQ(smile["name"], "Lip Corner Puller");
  EXPECT_EQ(smile["targets"]["left_zygomaticus_major"], 0.75) << "1.5 of 2";
  EXPECT_EQ(smile["targets"]["right_zygomaticus_major"], 0.75);
  EXPECT_EQ(smile["targets"]["left_depressor"], 0.125);
  EXPECT_FALSE(smile["targets"].contains("right_depressor"));
  EXPECT_FALSE(smile.contains("joints"));
}

TEST(FaceNotes, WhatAJointDoesIsAmongTheJoints) {
  const Noted noted(Basis::Muscles);
  const Json turned = noted.au(51);
  EXPECT_EQ(turned["joints"], (Json{{"head_turn_left", 1.0}}));
  EXPECT_FALSE(turned.contains("targets"));
  EXPECT_EQ(noted.au(61)["joints"].size(), 2U) << "both eyes";
  // The jaw is a joint; its target is the little that the joint leaves.
  const Json dropped = noted.au(26);
  EXPECT_EQ(dropped["joints"]["jaw"], 0.55);
  if (dropped.contains("targets")) {
    for (const auto& [name, weight] : dropped["targets"].items()) {
      EXPECT_TRUE(name.starts_with("jaw")) << name;
    }
  }
}

TEST(FaceNotes, ALidsArcHasTheWeightThatItsWayAsks) {
  const Noted noted(Basis::Muscles);
  const Json squint = noted.au(6);
  EXPECT_EQ(squint["targets"]["left_lid_close"], 0.25);
  EXPECT_EQ(squint["targets"]["left_lid_close_arc"], 0.75) << "4 w (1 - w)";
  EXPECT_FALSE(noted.au(43)["targets"].contains("left_lid_close_arc"))
      << "at its end there is none";
}

TEST(FaceNotes, OfTargetsOfActionUnitsEachHasItsOwnTwo) {
  const Noted noted(Basis::Aus);
  EXPECT_EQ(noted.notes["basis"], "aus");
  EXPECT_EQ(noted.au(12)["targets"], (Json{{"AU12_L", 1.0}, {"AU12_R", 1.0}}));
  EXPECT_EQ(noted.au(26)["targets"], (Json{{"AU26_L", 1.0}, {"AU26_R", 1.0}}))
      << "the jaw is no joint here";
  EXPECT_FALSE(noted.au(26).contains("joints"));
}

TEST(FaceNotes, ACurveOfARKitIsOneSideOfAnActionUnit) {
  About about;
  about.curves.curves = {{"mouthSmileLeft", 12, Side::Left, 1},
                         {"jawOpen", 26, Side::Both, 1},
                         {"cheekPuff", 34, Side::Both, 1}};
  const Noted noted(Basis::Muscles, about);
  const Json& curves = noted.notes["arkit52"];
  EXPECT_EQ(curves["mouthSmileLeft"]["au"], 12);
  EXPECT_EQ(curves["mouthSmileLeft"]["side"], "left");
  EXPECT_EQ(curves["mouthSmileLeft"]["targets"], (Json{{"left_zygomaticus_major", 0.75},
                                                       {"left_depressor", 0.125},
                                                       {"left_depressor_arc", 0.4375}}));
  EXPECT_EQ(curves["jawOpen"]["joints"], (Json{{"jaw", 0.55}}));
  EXPECT_FALSE(curves.contains("cheekPuff")) << "this face cannot puff its cheeks";
}

TEST(FaceNotes, SayWhatJointsDoAtTheirMost) {
  const Noted noted(Basis::Muscles);
  const Json& channels = noted.notes["jointChannels"];
  const Json& turned = channels["head_turn_left"];
  EXPECT_EQ(turned.size(), 2U) << "neck and head";
  // About the vertical, together by the 35 degrees of a whole turn.
  const auto half_angle = [&turned](const char* joint) {
    const Json& rotation = turned[joint]["rotation"];
    EXPECT_EQ(rotation[0], 0.0);
    EXPECT_EQ(rotation[2], 0.0);
    return std::atan2(rotation[1].get<double>(), rotation[3].get<double>());
  };
  constexpr double kDegrees = 3.14159265 / 180;
  EXPECT_NEAR(half_angle("neck") + half_angle("head"), 17.5 * kDegrees, 1e-3);
  EXPECT_GT(half_angle("neck"), 0) << "to the subject's left";
  EXPECT_EQ(channels["left_gaze_up"].size(), 1U);
  EXPECT_FALSE(channels.contains("left_zygomaticus_major"));
  // A slide forward is in metres, as the file is.
  EXPECT_NEAR(channels["head_forward"]["neck"]["shift"][2].get<double>() +
                  channels["head_forward"]["head"]["shift"][2].get<double>(),
              0.014, 1e-4);
}

TEST(FaceNotes, LeaveOutWhatIsNotKnown) {
  const Noted bare(Basis::Muscles);
  EXPECT_FALSE(bare.notes.contains("licence"));
  EXPECT_FALSE(bare.notes.contains("sound"));
  EXPECT_EQ(bare.notes["face"], "small");
  const Noted whole(Basis::Muscles, {"CC0", "talk.ogg", {}});
  EXPECT_EQ(whole.notes["licence"], "CC0");
  EXPECT_EQ(whole.notes["sound"]["file"], "talk.ogg");
}

TEST(FaceNotes, ARecordingOfNeutralIsNoActionUnit) {
  face::Face face = small_face();
  face.recordings[0] = {0, std::vector<float>(face.channels.size()), "neutral"};
  const Noted noted(Basis::Aus, {}, std::move(face));
  const Json& all = noted.notes["actionUnits"];
  EXPECT_TRUE(
      std::none_of(all.begin(), all.end(), [](const Json& one) { return one["number"] == 0; }));
  EXPECT_EQ(all.size() + 1, noted.face.recordings.size());
}

TEST(FaceNotes, AnAuThatFacsDoesNotNameHasNoName) {
  face::Face face = small_face();
  face.recordings[90] = {90, face::test::only(face, "jaw", 1), "my own"};
  const Noted noted(Basis::Muscles, {}, std::move(face));
  EXPECT_FALSE(noted.au(90).contains("name"));
}

}  // namespace
}  // namespace aucast::glb
