#include "common/action_unit.h"

#include <utility>

#include <gtest/gtest.h>

namespace aucast {
namespace {

using Terms = std::vector<AuTerm>;

TEST(AuFrame, LastOfARepeatedAuAndSideWins) {
  const AuFrame frame = frame_from_terms(Terms{
      {12, Side::Both, 80}, {12, Side::Left, 30}, {12, Side::Left, 50}, {4, Side::Right, 100}});
  EXPECT_FLOAT_EQ(frame.left[12], 0.5F);
  EXPECT_FLOAT_EQ(frame.right[12], 0.8F);
  EXPECT_FLOAT_EQ(frame.left[4], 0.0F);
  EXPECT_FLOAT_EQ(frame.right[4], 1.0F);
}

TEST(AuFrame, NeutralAddsNothingBesideOthers) {
  EXPECT_EQ(frame_from_terms(Terms{{0, Side::Both, 100}, {6, Side::Both, 100}}),
            frame_from_terms(Terms{{6, Side::Both, 100}}));
}

TEST(AuFrame, ChangesKeepWhatTheyDoNotName) {
  AuFrame frame = frame_from_terms(Terms{{1, Side::Both, 100}, {12, Side::Both, 40}});
  apply_terms(frame, Terms{{12, Side::Both, 0}, {6, Side::Left, 20}});
  EXPECT_EQ(canonical_terms(frame), (Terms{{1, Side::Both, 100}, {6, Side::Left, 20}}));
}

TEST(CanonicalTerms, AscendJoinEqualSidesAndDropZeros) {
  AuFrame frame;
  frame.left[12] = frame.right[12] = 0.8F;
  frame.left[4] = 0.25F;
  frame.right[4] = 0.5F;
  frame.right[1] = 0.004F;  // rounds to nothing
  EXPECT_EQ(canonical_terms(frame),
            (Terms{{4, Side::Left, 25}, {4, Side::Right, 50}, {12, Side::Both, 80}}));
}

TEST(CanonicalTerms, NothingLeftIsNeutral) {
  EXPECT_EQ(canonical_terms(AuFrame{}), (Terms{{0, Side::Both, 100}}));
}

TEST(CanonicalTerms, KeepEveryWholePercent) {
  for (int percent = 0; percent <= 100; ++percent) {
    const Terms terms{{7, Side::Both, static_cast<std::uint8_t>(percent)}};
    const Terms expected = percent == 0 ? Terms{{0, Side::Both, 100}} : terms;
    EXPECT_EQ(canonical_terms(frame_from_terms(terms)), expected) << percent;
  }
}

TEST(CanonicalTerms, WhatShowsOnOneSideKeepsItsSide) {
  for (const std::uint8_t number : std::vector<std::uint8_t>{30, 36, 46}) {
    EXPECT_EQ(canonical_terms(frame_from_terms(Terms{{number, Side::Both, 80}})),
              (Terms{{number, Side::Right, 80}}));
    const Terms both{{number, Side::Left, 80}, {number, Side::Right, 80}};
    EXPECT_EQ(canonical_terms(frame_from_terms(both)), both);
  }
}

TEST(FacsName, KnowsTheCodesOf1978And2002) {
  EXPECT_EQ(facs_name(12), "Lip Corner Puller");
  EXPECT_EQ(facs_name(46), "Wink");
  EXPECT_EQ(facs_name(66), "Cross-eye");
  for (const int number : {8, 40, 41, 42, 44, 50, 80, 81, 82, 84, 85}) {
    EXPECT_TRUE(facs_name(number).has_value()) << number;
  }
  EXPECT_FALSE(facs_name(3).has_value());
  EXPECT_FALSE(facs_name(99).has_value());
  EXPECT_FALSE(facs_name(-1).has_value());
}

TEST(FacsNumber, IsFoundByEveryNameAndByNothingElse) {
  for (int number = 0; number <= kAuNumberMax; ++number) {
    const auto name = facs_name(number);
    if (!name) continue;
    EXPECT_EQ(facs_number(*name), number) << *name;
  }
  EXPECT_EQ(facs_number("inner brow raiser"), 1);
  EXPECT_EQ(facs_number(" Cross eye "), 66);
  EXPECT_EQ(facs_number("Cheek Puffer"), 13) << "as the thesis calls it";
  for (const char* other : {"smile", "", "12", "Inner Brow"}) {
    EXPECT_FALSE(facs_number(other).has_value()) << other;
  }
}

TEST(FacsNumber, KnowsEveryNameOfTheThesis) {
  // Appendix C, both tables.
  const std::pair<int, const char*> names[] = {
      {1, "Inner Brow Raiser"},
      {2, "Outer Brow Raiser"},
      {4, "Brow Lowerer"},
      {5, "Upper Lid Raiser"},
      {6, "Cheek Raiser"},
      {7, "Lid Tightener"},
      {9, "Nose Wrinkler"},
      {10, "Upper Lip Raiser"},
      {11, "Nasolabial Fold Deepener"},
      {12, "Lip Corner Puller"},
      {13, "Cheek Puffer"},
      {14, "Dimpler"},
      {15, "Lip Corner Depressor"},
      {16, "Lower Lip Depressor"},
      {17, "Chin Raiser"},
      {18, "Lip Puckerer"},
      {20, "Lip Stretcher"},
      {21, "Neck Tightner"},
      {22, "Lip Funneler"},
      {23, "Lip Tightener"},
      {24, "Lip Pressor"},
      {25, "Lips Part"},
      {26, "Jaw Drop"},
      {27, "Mouth Stretch"},
      {28, "Lip Suck"},
      {31, "Jaw Clencher"},
      {38, "Nostril Dilator"},
      {39, "Nostril Compressor"},
      {43, "Eyes Closed"},
      {45, "Blink"},
      {46, "Wink"},
      {19, "Tongue out"},
      {29, "Jaw Thrust"},
      {30, "Jaw Sideways"},
      {32, "Lip Bite"},
      {33, "Cheek Blow"},
      {34, "Cheek Puff"},
      {35, "Cheek Suck"},
      {36, "Tongue Bulge"},
      {37, "Lip Wipe"},
      {51, "Head Turn Left"},
      {52, "Head Turn Right"},
      {53, "Head Up"},
      {54, "Head Down"},
      {55, "Head Tilt Left"},
      {56, "Head Tilt Right"},
      {57, "Head Forward"},
      {58, "Head Back"},
      {61, "Eyes Turn Left"},
      {62, "Eyes Turn Right"},
      {63, "Eyes Up"},
      {64, "Eyes Down"},
      {65, "Walleye"},
      {66, "Cross-eye"},
  };
  for (const auto& [number, name] : names) EXPECT_EQ(facs_number(name), number) << name;
}

TEST(Between, EndsAtBothFramesAndKeepsSidesApart) {
  const AuFrame from = frame_from_terms(Terms{{12, Side::Left, 20}});
  const AuFrame to = frame_from_terms(Terms{{12, Side::Both, 80}, {4, Side::Right, 30}});
  EXPECT_EQ(between(from, to, 0), from);
  EXPECT_EQ(between(from, to, 1), to);
  EXPECT_EQ(canonical_terms(between(from, to, 0.5)),
            (Terms{{4, Side::Right, 15}, {12, Side::Left, 50}, {12, Side::Right, 40}}));
}

TEST(Stronger, TakesEachSideOfEachAuFromTheFrameThatHasMoreOfIt) {
  const AuFrame a = frame_from_terms(Terms{{12, Side::Left, 20}, {12, Side::Right, 90}});
  const AuFrame b = frame_from_terms(Terms{{12, Side::Both, 80}, {4, Side::Right, 30}});
  const AuFrame both =
      frame_from_terms(Terms{{4, Side::Right, 30}, {12, Side::Left, 80}, {12, Side::Right, 90}});
  EXPECT_EQ(stronger(a, b), both);
  EXPECT_EQ(stronger(b, a), both);
}

TEST(PercentOf, RoundsAndCuts) {
  EXPECT_EQ(percent_of(0.004F), 0);
  EXPECT_EQ(percent_of(0.005F), 1);
  EXPECT_EQ(percent_of(1.5F), 100);
  EXPECT_EQ(percent_of(-1), 0);
}

TEST(SidedName, IsPutTogetherAndTakenApart) {
  for (const Side side : {Side::Left, Side::Right, Side::Both}) {
    const std::string name = sided_name(side, "brow");
    EXPECT_EQ(split_side(name).side, side);
    EXPECT_EQ(split_side(name).base, "brow");
    EXPECT_EQ(opposite(opposite(side)), side);
  }
  EXPECT_EQ(sided_name(opposite(Side::Left), "brow"), "right_brow");
}

TEST(PercentOfLetter, KnowsBothEditionsOfFacs) {
  EXPECT_EQ(percent_of_letter('A'), 10);
  EXPECT_EQ(percent_of_letter('B'), 25);
  EXPECT_EQ(percent_of_letter('C'), 50);
  EXPECT_EQ(percent_of_letter('D'), 80);
  EXPECT_EQ(percent_of_letter('E'), 100);
  EXPECT_EQ(percent_of_letter('x'), 25);
  EXPECT_EQ(percent_of_letter('y'), 60);
  EXPECT_EQ(percent_of_letter('z'), 100);
  EXPECT_FALSE(percent_of_letter('a').has_value());
  EXPECT_FALSE(percent_of_letter('X').has_value());
}

}  // namespace
}  // namespace aucast
