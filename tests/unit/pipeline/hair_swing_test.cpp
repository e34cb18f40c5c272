#include "client/pipeline/hair_swing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace aucast::pipeline {
namespace {

const Instant kTurnBegin{std::chrono::hours(1)};

face::Face long_haired_face() {
  face::Face face;
  for (const char* name : {"head_turn_left", "head_turn_right", "head_up", "head_down",
                           "head_tilt_left", "head_tilt_right"}) {
    face.channels.push_back({name, Side::Both, 1});
  }
  face.head = face::HeadPose{};
  face.hair = face::Hair{};
  return face;
}

class HairSwingTest : public ::testing::Test {
 protected:
  /// The head, turned to the left by a share of its full turn.
  static std::vector<float> turned(float share) { return {share, 0, 0, 0, 0, 0}; }
  /// The head at `ms` of a turn that takes 0.4 s.
  static std::vector<float> at_ms(int ms) {
    return turned(std::clamp(static_cast<float>(ms) / 400, 0.0F, 1.0F));
  }
  static Instant after_ms(int ms) { return kTurnBegin + Milliseconds(ms); }
  /// The head turns from `from` to 0.4 s, looked at every `step_ms`.
  static void turn(HairSwing& swing, int from_ms = 0, int step_ms = 10) {
    for (int ms = from_ms; ms <= 400; ms += step_ms) swing.move(after_ms(ms), at_ms(ms));
  }

  face::Face face_ = long_haired_face();
  HairSwing swing_{face_};
};

TEST_F(HairSwingTest, HairStaysBehindAndThenSwingsPast) {
  turn(swing_);
  float furthest = 0;
  float past = 0;
  for (int ms = 0; ms <= 1000; ++ms) {
    const face::HairSway sway = swing_.at(after_ms(ms));
    furthest = std::min(furthest, sway.turn);
    past = std::max(past, sway.turn);
    EXPECT_EQ(sway.pitch, 0);
    EXPECT_EQ(sway.tilt, 0);
    if (ms > 0 && ms <= 400) {
      EXPECT_LT(sway.turn, 0) << ms;
    }
  }
  EXPECT_LT(furthest, -0.5F);
  EXPECT_GT(past, 0.02F);
  EXPECT_LT(past, -furthest / 2);
}

TEST_F(HairSwingTest, ItSettlesToTheLastBit) {
  turn(swing_);
  const Instant settled = after_ms(400) + HairSwing::kMemory;
  EXPECT_TRUE(swing_.swings(settled - Milliseconds(1)));
  EXPECT_FALSE(swing_.swings(settled));
  EXPECT_EQ(swing_.at(settled), face::HairSway{});
  EXPECT_EQ(swing_.at(settled + std::chrono::hours(1)), face::HairSway{});
}

TEST_F(HairSwingTest, AHeadThatStandsStillHasItsHairAtRest) {
  for (int ms = 0; ms <= 400; ms += 10) swing_.move(after_ms(ms), turned(0.7F));
  EXPECT_FALSE(swing_.swings(after_ms(400)));
  EXPECT_EQ(swing_.at(after_ms(400)), face::HairSway{});
}

TEST_F(HairSwingTest, EachAxisFollowsItsOwn) {
  swing_.move(kTurnBegin, std::vector<float>(6));
  swing_.move(after_ms(200), std::vector<float>{0, 0, 1, 0, 0, 1});
  const face::HairSway sway = swing_.at(after_ms(200));
  EXPECT_EQ(sway.turn, 0);
  EXPECT_LT(sway.pitch, 0);
  EXPECT_GT(sway.tilt, 0);
}

TEST_F(HairSwingTest, AJumpSwingsItNoFurtherThanItMay) {
  swing_.move(kTurnBegin, turned(-1));
  swing_.move(kTurnBegin, turned(1));
  for (int ms = 0; ms <= 600; ++ms) {
    const float sway = swing_.at(after_ms(ms)).turn;
    EXPECT_GT(sway, -1);
    EXPECT_LT(sway, 1);
  }
  EXPECT_LT(swing_.at(kTurnBegin).turn, -0.9F);
}

TEST_F(HairSwingTest, HowOftenTheHeadIsLookedAtDoesNotCount) {
  HairSwing seldom(face_);
  turn(swing_);
  turn(seldom, 0, 200);
  for (int ms = 0; ms <= 1000; ms += 7) {
    // The head of this turn goes straight on.
    EXPECT_NEAR(swing_.at(after_ms(ms)).turn, seldom.at(after_ms(ms)).turn, 1e-5F) << ms;
  }
}

TEST_F(HairSwingTest, WhatWasBeforeItsMemoryDoesNotCount) {
  swing_.move(kTurnBegin - std::chrono::seconds(5), turned(-1));
  swing_.move(kTurnBegin - std::chrono::seconds(1), turned(0.3F));
  swing_.move(kTurnBegin - std::chrono::seconds(1), turned(0));
  turn(swing_);
  HairSwing sought(face_);
  turn(sought);
  const HairSwing with_all = swing_;
  swing_.forget_before(after_ms(100));
  for (int ms = 100; ms <= 1000; ms += 10) {
    EXPECT_EQ(swing_.at(after_ms(ms)), sought.at(after_ms(ms))) << ms;
    EXPECT_EQ(swing_.at(after_ms(ms)), with_all.at(after_ms(ms))) << ms;
  }
}

TEST_F(HairSwingTest, WhereverPlayingBeginsAfterItsMemoryItIsTheSame) {
  turn(swing_);
  for (int from_ms = 0; from_ms <= 300; from_ms += 50) {
    HairSwing sought(face_);
    sought.put(after_ms(from_ms), at_ms(from_ms));
    EXPECT_EQ(sought.at(after_ms(from_ms)), face::HairSway{}) << from_ms;
    turn(sought, from_ms);
    const Instant later = after_ms(from_ms) + HairSwing::kMemory;
    for (int ms = 0; ms <= 500; ms += 10) {
      EXPECT_EQ(sought.at(later + Milliseconds(ms)), swing_.at(later + Milliseconds(ms)));
    }
  }
}

TEST_F(HairSwingTest, AFaceThatIsPutSomewhereIsAStill) {
  swing_.put(kTurnBegin, turned(-1));
  swing_.put(after_ms(10), turned(1));
  EXPECT_EQ(swing_.at(after_ms(10)), face::HairSway{});
}

TEST_F(HairSwingTest, AFaceThatIsLeftWhereItIsSettles) {
  turn(swing_);
  swing_.put(after_ms(410), turned(1));
  EXPECT_LT(swing_.at(after_ms(410)).turn, -0.1F);
  EXPECT_FALSE(swing_.swings(after_ms(1000)));
}

TEST_F(HairSwingTest, WithoutHairThatSwingsNothingDoes) {
  for (const bool no_hair : {true, false}) {
    face::Face face = long_haired_face();
    if (no_hair) face.hair.reset();
    if (!no_hair) face.hair->swing_deg = 0;
    HairSwing swing(face);
    swing.move(kTurnBegin, turned(-1));
    swing.move(after_ms(100), turned(1));
    EXPECT_FALSE(swing.swings(after_ms(100)));
    EXPECT_EQ(swing.at(after_ms(100)), face::HairSway{});
  }
}

}  // namespace
}  // namespace aucast::pipeline
