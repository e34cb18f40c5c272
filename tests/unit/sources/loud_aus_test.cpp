#include "common/sources/loud_aus.h"

#include <gtest/gtest.h>

#include "common/sources/found_report.h"
#include "common/sources/recording.h"
#include "tests/support/read_recording.h"
#include "tests/unit/sources/tables.h"

namespace aucast::sources {
namespace {

using tables::kOpenFace2Header;
using tables::openface2_row;

/// Ten rows a second: AU 1 and AU 12 of 0-5 up to `until_s`, and then a neutral face.
std::string loud_at_first(double until_s, double all_s) {
  std::string text = kOpenFace2Header;
  for (int row = 0; row < static_cast<int>(all_s * 10); ++row) {
    const bool loud = row < static_cast<int>(until_s * 10);
    text += openface2_row(row + 1, std::to_string(row / 10.0),
                          loud ? "2.0,5.0,0,0,1,0,0" : "0.5,0.2,0,0,0,0,0");
  }
  return text;
}

Found found_with(const std::string& text, double neutral_s, bool turns_only = false) {
  ConditioningSettings conditioning;
  conditioning.neutral_seconds = neutral_s;
  conditioning.neutral_turns_only = turns_only;
  auto recording = read_recording(text, "f.csv", {}, conditioning);
  if (recording) return std::move(recording->found);
  ADD_FAILURE() << recording.error().message;
  return {};
}

TEST(LoudAus, NamesTheStrongestAusThatNoNeutralFaceHas) {
  MeasuredNeutral neutral;
  const auto set = [&](std::size_t number, float left, float right) {
    neutral.signals[channel_of(number, false)] = left;
    neutral.signals[channel_of(number, true)] = right;
  };
  set(1, 0.3F, 0.3F);
  set(54, 0.9F, 0.9F);
  set(53, 0.9F, 0.9F);
  set(63, -0.7F, -0.7F);
  EXPECT_TRUE(loud_aus(neutral).empty()) << "a camera that stands aside";
  set(10, 0.5F, 0.1F);
  set(7, 1, 1);
  EXPECT_EQ(loud_aus(neutral),
            (std::vector<LoudAu>{{{7, Side::Both}, 100}, {{10, Side::Left}, 50}}));
  EXPECT_EQ(loud_text(loud_aus(neutral)), "AU7 100 %, AUL10 50 %");
  set(20, 0.9F, 0.9F);
  set(5, 0.4F, 0.4F);
  EXPECT_EQ(loud_text(loud_aus(neutral)), "AU7 100 %, AU20 90 %, AUL10 50 % and 1 more");
}

TEST(LoudAus, ASpanThatIsNeutralIsRecommended) {
  const Found found = found_with(loud_at_first(2, 30), 2);
  ASSERT_EQ(found.not_neutral.size(), 2U);
  EXPECT_EQ(found.not_neutral[0].au.number, 12);
  EXPECT_EQ(found.neutral_seconds, 20.0) << "of which nine tenths are neutral";
  const std::string said =
      "AU12 100 %, AU1 40 %: no neutral face was subtracted; --neutral 20 subtracts one";
  EXPECT_EQ(warnings(found), std::vector<std::string>{said});
  EXPECT_NE(found_lines(found).find("  not neutral " + said + "\n"), std::string::npos);
  EXPECT_NE(found_sentence(found).find(said), std::string::npos);
}

TEST(LoudAus, AFaceThatMovesIsNotAtRestThoughItsMedianIsWeak) {
  const Found found = found_with(loud_at_first(2, 5), 5);
  EXPECT_EQ(warnings(found),
            std::vector<std::string>{"movement of AU12 96 %: no neutral face was subtracted; leave "
                                     "out --neutral, or cut what is before the face is neutral"});
}

TEST(LoudAus, EyelidsBlinkAndFollowTheEyesOfAFaceAtRest) {
  MeasuredNeutral neutral;
  for (const std::size_t number : {5U, 45U, 63U}) neutral.movement[number] = 0.9F;
  EXPECT_TRUE(loud_aus(neutral).empty());
  neutral.movement[7] = 0.31F;
  EXPECT_EQ(loud_aus(neutral), (std::vector<LoudAu>{{{7, Side::Left}, 31, true}}));
  EXPECT_EQ(loud_text(loud_aus(neutral)), "movement of AUL7 31 %");
}

TEST(LoudAus, WithoutSuchASpanItIsToBeLeftOut) {
  const Found found = found_with(loud_at_first(3, 4), 1);
  EXPECT_FALSE(found.neutral_seconds);
  EXPECT_EQ(warnings(found, {"Fps", "'Neutral'"}),
            std::vector<std::string>{"AU12 100 %, AU1 40 %: no neutral face was subtracted; leave "
                                     "out 'Neutral', or cut what is before the face is neutral"});
}

TEST(LoudAus, ANeutralFaceAndTurnsAloneAreNoReasonToWarn) {
  EXPECT_TRUE(warnings(found_with(loud_at_first(0, 3), 2)).empty());
  EXPECT_TRUE(warnings(found_with(loud_at_first(3, 3), 2, true)).empty());
}

TEST(LoudAus, OfTurnsAloneNothingElseIsSaidToBeTakenOff) {
  const Found found = found_with(loud_at_first(3, 3), kWholeRecordingSeconds, true);
  EXPECT_NE(found_lines(found).find(" rows of 3 s: nothing over 1 %\n"), std::string::npos)
      << found_lines(found);
}

}  // namespace
}  // namespace aucast::sources
