#include "speaker/cues.h"

#include <gtest/gtest.h>

#include "common/au_numbers.h"
#include "tests/unit/speaker/performed.h"

namespace aucast::speaker {
namespace {

TEST(SetsOf, HasNoAusForWhatIsMadeOfMusclesAlone) {
  std::vector<Expression> read(3);
  read[0].name = "neutral";
  read[1].name = "joy";
  set_intensity(read[1].aus, 12, Side::Both, 0.6F);
  read[1].muscles = read[2].muscles = {{"zygomaticus_major", {}, 1, 1}};
  read[2].name = "pull";
  EXPECT_EQ(sets_of(read), (Expressions{{"neutral", {{0, Side::Both, 100}}},
                                        {"joy", {{12, Side::Both, 60}}},
                                        {"pull", {}}}));
}

/// What is said of a text with cues; empty: they are right.
std::string complaint(const std::string& text) {
  const Expressions expressions{{"happiness-12C", {{12, Side::Both, 50}}},
                                {"surprise", {{1, Side::Both, 100}}},
                                {"mild 50", {{1, Side::Both, 20}}},
                                {"waters-fear", {}}};
  const auto script = parse_script(text, "t.txt");
  EXPECT_TRUE(script);
  const auto checked = check_cues(*script, expressions, "t.txt");
  if (checked) return "";
  EXPECT_EQ(checked.error().kind, ErrorKind::BadData);
  return checked.error().message;
}

TEST(CheckCues, TakeExpressionsPercentAndAus) {
  for (const char* cue : {"L12:40",
                          "12C,R2:10",
                          "6,12:60",
                          "{6+12}",
                          "R14",
                          "0",
                          "Surprise 40",
                          "surprise",
                          "happiness-12C",
                          "Happiness-12c",
                          "happiness-12C 50",
                          "smile",
                          "SMILE 100",
                          "smile 0",
                          "mild 50",
                          "Mild 50",
                          "mild 50 50",
                          "6,12:60 50",
                          "6, 12",
                          "6 + 12"}) {
    EXPECT_EQ(complaint("[" + std::string(cue) + "] a"), "") << cue;
  }
}

TEST(CheckCues, NameTheNearestExpressionOrWhereTheyAreListed) {
  EXPECT_EQ(complaint("hello [suprise] a"),
            "t.txt:1:7: [suprise] is no expression; did you mean [surprise]?");
  EXPECT_EQ(complaint("hello\n\n[suprise 40] a"),
            "t.txt:3:1: [suprise] is no expression; did you mean [surprise]?");
  EXPECT_EQ(complaint("[see page] a"),
            "t.txt:1:1: [see page] is no expression; [smile], AUs and the names of `face-player "
            "pose --list` are");
  EXPECT_NE(complaint("[] a"), "");
}

TEST(CheckCues, TellOfAWrongPercent) {
  for (const char* percent : {"500", "101", "-1", "50.5"}) {
    const std::string cue = "[smile " + std::string(percent) + "]";
    EXPECT_EQ(complaint(cue + " a"),
              "t.txt:1:1: " + cue + " has a percent that is no whole number from 0 to 100");
  }
}

TEST(CheckCues, TellWhatIsWrongWithAus) {
  EXPECT_EQ(complaint("[6,12:900] a"),
            "t.txt:1:1: AU set '6,12:900', column 8: an intensity is 0-100 percent");
  EXPECT_NE(complaint("[6;400] a").find("a time (';') has a meaning in a stream"),
            std::string::npos);
  EXPECT_NE(complaint("[R12Z] a").find("AU set 'R12Z', column 4"), std::string::npos);
}

TEST(CheckCues, TellThatMusclesAreNotCarried) {
  for (const char* cue : {"[waters-fear]", "[Waters-Fear 40]"}) {
    EXPECT_NE(complaint(cue + std::string(" a")).find("is made of muscles alone, which no stream"),
              std::string::npos)
        << cue;
  }
  EXPECT_EQ(complaint("[waters-fer] a").find("waters-fear"), std::string::npos)
      << "nor is it proposed";
}

constexpr double kNear = 8;  ///< percent: the tolerance of the keyframes, and what is rounded

TEST(Cues, ShowWhollyFromTheirWordAndBeginBeforeIt) {
  const Performed face("one [brows] two three");
  EXPECT_NEAR(face.at(3000, kOuterBrowRaiser), 80, kNear) << "the second word";
  EXPECT_NEAR(face.at(2825, kOuterBrowRaiser), 40, kNear) << "half of 350 ms before";
  EXPECT_EQ(face.at(2600, kOuterBrowRaiser), 0);
  EXPECT_NEAR(face.at(5000, kOuterBrowRaiser), 80, kNear) << "the end of the text is its end";
}

TEST(Cues, EndWithTheParagraphInSixTenthsOfASecond) {
  const Performed face("[brows] one two\n\nthree four");
  EXPECT_NEAR(face.at(4000, kOuterBrowRaiser), 80, kNear) << "the third word begins";
  EXPECT_NEAR(face.at(4300, kOuterBrowRaiser), 40, kNear);
  EXPECT_EQ(face.at(4700, kOuterBrowRaiser), 0);
}

TEST(Cues, EndWithTheNextOneAndZeroIsNoExpression) {
  const Performed face("[brows] one [smirk] two [0] three");
  EXPECT_EQ(face.at(3700, kOuterBrowRaiser), 0);
  EXPECT_NEAR(face.at(3500, kLipCornerPuller, Side::Left), 55, kNear)
      << "what a speaking mouth leaves of a smile";
  EXPECT_EQ(face.at(3500, kLipCornerPuller), 0) << "of one side";
  EXPECT_EQ(face.at(4800, kLipCornerPuller, Side::Left), 0);
}

TEST(Cues, ArePercentOfTheirExpression) {
  EXPECT_NEAR(Performed("[brows 50] one two").at(3000, kOuterBrowRaiser), 40, kNear);
  EXPECT_NEAR(Performed("[BROWS 50] one two").at(3000, kOuterBrowRaiser), 40, kNear);
  EXPECT_NEAR(Performed("[2:60 50] one two").at(3000, kOuterBrowRaiser), 30, kNear);
  EXPECT_EQ(Performed("[brows 0] one two").at(3000, kOuterBrowRaiser), 0);
  EXPECT_NEAR(Performed("[smile] one two").at(3000, kCheekRaiser), 50, kNear);
}

TEST(Cues, LeaveTheLipsToWhatTheySay) {
  EXPECT_EQ(Performed("[gape] one two").at(3000, kJawDrop), 0);
}

TEST(Cues, AfterTheLastWordAskForNothing) {
  const Performed face("one two [brows]");
  for (int ms = 0; ms < face.length().count(); ms += 100) {
    EXPECT_EQ(face.at(ms, kOuterBrowRaiser), 0) << ms;
  }
}

}  // namespace
}  // namespace aucast::speaker
