#include "common/sources/conditioning.h"

#include <gtest/gtest.h>

#include "common/sources/live_timeline.h"
#include "common/sources/timeline.h"
#include "tests/support/seeded.h"

namespace aucast::sources {
namespace {

AuFrame face(std::initializer_list<std::pair<std::size_t, float>> aus) {
  AuFrame frame = no_data();
  for (const auto& [number, value] : aus) frame.left[number] = frame.right[number] = value;
  return frame;
}

Signals neutral(std::initializer_list<std::pair<std::size_t, float>> aus) {
  return signals_of(face(aus));
}

TEST(Conditioning, WithoutSettingsNothingHappensButTheBounds) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  Conditioning off;
  for (int row = 0; row < 100; ++row) {
    AuFrame update = no_data();
    for (std::size_t number = 1; number < kAuCount; ++number) {
      if (number == 57 || number == 58) continue;
      update.left[number] = static_cast<float>(seeded.real(0, 1));
      if (seeded.real(0, 1) < 0.5) update.right[number] = static_cast<float>(seeded.real(0, 1));
    }
    EXPECT_EQ(off.apply(row, update), update);
  }
  const AuFrame shown = off.apply(200, face({{51, 1.5F}, {58, 30}}));
  EXPECT_EQ(shown.left[51], 1);
  EXPECT_EQ(shown.left[58], -1) << "the distance is only there when it is asked for";
}

TEST(Conditioning, TheNeutralFaceIsTakenOffBeforeTheGain) {
  ConditioningSettings settings;
  settings.profile.neutral = neutral({{4, 0.25F}, {51, 0}, {52, 0.5F}});
  settings.profile.gain.set({4, Side::Both}, 2);
  settings.profile.gain.set({51, Side::Both}, 0.5);
  Conditioning conditioning(settings);
  const AuFrame shown = conditioning.apply(0, face({{4, 0.5F}, {12, 0.5F}, {51, 0}, {52, 0.25F}}));
  EXPECT_FLOAT_EQ(shown.left[4], 0.5F);
  EXPECT_FLOAT_EQ(shown.left[12], 0.5F);
  EXPECT_FLOAT_EQ(shown.left[51], 0.125F) << "less to the right than when neutral is to the left";
  EXPECT_EQ(shown.left[52], 0);
  EXPECT_EQ(shown.left[1], -1) << "no data stays no data";
  EXPECT_EQ(conditioning.apply(1, face({{4, 0.1F}})).left[4], 0);
  EXPECT_EQ(conditioning.apply(2, face({{4, 0.9F}})).left[4], 1);
}

TEST(Conditioning, AHeadThatIsTurnedBeyondFullIsMeasuredWhole) {
  ConditioningSettings settings;
  settings.profile.neutral = neutral({{53, 1.25F}, {54, 0}});
  Conditioning conditioning(settings);
  EXPECT_FLOAT_EQ(conditioning.apply(0, face({{53, 1.75F}, {54, 0}})).left[53], 0.5F);
}

TEST(Conditioning, WhileItMeasuresTheMedianSoFarIsNeutral) {
  ConditioningSettings settings;
  settings.neutral_seconds = 0.25;
  Conditioning conditioning(settings);
  EXPECT_EQ(conditioning.apply(5, face({{12, 0.5F}})).left[12], 0);
  EXPECT_FLOAT_EQ(conditioning.apply(5.1, face({{12, 0.75F}})).left[12], 0.125F);
  EXPECT_FLOAT_EQ(conditioning.apply(5.2, face({{12, 0.5F}})).left[12], 0);
  EXPECT_FALSE(conditioning.take_neutral());
  EXPECT_FLOAT_EQ(conditioning.apply(5.3, face({{12, 1}})).left[12], 0.5F);
  const auto measured = conditioning.take_neutral();
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->rows, 3U);
  EXPECT_EQ(measured->signals[12], 0.5F);
  EXPECT_FALSE(conditioning.take_neutral()) << "once";
  EXPECT_FLOAT_EQ(conditioning.apply(9, face({{12, 1}})).left[12], 0.5F) << "and stays";
}

TEST(Conditioning, MeasuredGoesBeforeTheProfiles) {
  ConditioningSettings settings;
  settings.neutral_seconds = 1;
  settings.profile.neutral = neutral({{12, 0.5F}, {4, 0.25F}});
  Conditioning conditioning(settings);
  const AuFrame shown = conditioning.apply(0, face({{12, 0.75F}}));
  EXPECT_EQ(shown.left[12], 0);
  EXPECT_FLOAT_EQ(conditioning.apply(2, face({{4, 0.5F}})).left[4], 0.25F) << "never measured";
}

TEST(Conditioning, TheDistanceIsThatFromTheFirstSeconds) {
  ConditioningSettings settings;
  settings.distance = true;
  Conditioning conditioning(settings);
  // 420 mm, and 7 mm nearer.
  EXPECT_EQ(conditioning.apply(0, face({{57, 0}, {58, 30}})).left[57], 0);
  EXPECT_EQ(conditioning.apply(0.5, face({{57, 0}, {58, 30}})).left[58], 0);
  const AuFrame nearer = conditioning.apply(2, face({{57, 0}, {58, 29.5F}}));
  EXPECT_FLOAT_EQ(nearer.left[57], 0.5F);
  EXPECT_EQ(nearer.left[58], 0);
  EXPECT_FLOAT_EQ(conditioning.apply(3, face({{57, 0}, {58, 30.25F}})).left[58], 0.25F);
  EXPECT_FALSE(conditioning.take_neutral()) << "no neutral face was asked for";
}

TEST(Conditioning, TheDistanceIsMeasuredWhereOnlyTurnsAreTakenOff) {
  ConditioningSettings settings;
  settings.distance = settings.neutral_turns_only = true;
  Conditioning conditioning(settings);
  EXPECT_EQ(conditioning.apply(0, face({{57, 0}, {58, 30}})).left[58], 0);
  EXPECT_FLOAT_EQ(conditioning.apply(2, face({{57, 0}, {58, 30.25F}})).left[58], 0.25F);
}

TEST(Conditioning, TheDistanceOfAProfileIsNotMeasured) {
  ConditioningSettings settings;
  settings.distance = true;
  settings.profile.neutral = neutral({{57, 0}, {58, 30}});
  Conditioning conditioning(settings);
  EXPECT_FLOAT_EQ(conditioning.apply(0, face({{57, 0}, {58, 30.25F}})).left[58], 0.25F);
}

/// Noise around the neutral face: cut off at 0 before the filter, a third of its width would stay
/// as an expression.
TEST(Conditioning, NoiseAroundNeutralIsAveragedOut) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  ConditioningSettings settings;
  settings.profile.neutral = neutral({{4, 0.2F}});
  settings.profile.filter = OneEuroSettings{0.2, 0, 1};
  Conditioning conditioning(settings);
  double sum = 0;
  for (int row = 0; row < 1000; ++row) {
    const auto noise = static_cast<float>(seeded.real(-0.1, 0.1));
    sum += conditioning.apply(row / 30.0, face({{4, 0.2F + noise}})).left[4];
  }
  EXPECT_LT(sum / 1000, 0.01) << "0.025 when it is cut off first";
}

TEST(Conditioning, ChangedSettingsKeepWhatWasMeasured) {
  ConditioningSettings settings;
  settings.neutral_seconds = 0.1;
  Conditioning conditioning(settings);
  static_cast<void>(conditioning.apply(0, face({{12, 0.25F}})));
  static_cast<void>(conditioning.apply(1, face({{12, 0.25F}})));
  settings.profile.neutral = neutral({{12, 0.5F}});
  settings.profile.gain = PerAu(2);
  conditioning.change(settings);
  EXPECT_FLOAT_EQ(conditioning.apply(2, face({{12, 0.5F}})).left[12], 0.5F);
  settings.neutral_seconds.reset();
  Conditioning by_profile(settings);
  settings.profile.neutral = neutral({{12, 0.25F}});
  by_profile.change(settings);
  EXPECT_FLOAT_EQ(by_profile.apply(0, face({{12, 0.5F}})).left[12], 0.5F);
}

TEST(Conditioning, WhatIsForgottenIsMeasuredAnew) {
  ConditioningSettings settings;
  settings.neutral_seconds = 1;
  Conditioning conditioning(settings);
  static_cast<void>(conditioning.apply(0, face({{12, 0.8F}})));
  conditioning.forget_neutral();
  EXPECT_EQ(conditioning.apply(0.5, face({{12, 0.2F}})).left[12], 0);
  EXPECT_FLOAT_EQ(conditioning.apply(1.6, face({{12, 0.4F}})).left[12], 0.2F);
  EXPECT_EQ(conditioning.take_neutral()->rows, 1U);
}

TEST(Conditioning, ARecordingAndALiveSourceAreConditionedAlike) {
  ConditioningSettings settings;
  settings.profile.neutral = neutral({{12, 0.1F}});
  settings.profile.gain = PerAu(1.5);
  settings.profile.filter = OneEuroSettings{1, 1, 1};
  settings.profile.dead_band = PerAu(0);
  Timeline recording(settings);
  LiveTimeline live({}, settings);
  for (int row = 0; row < 60; ++row) {
    const AuFrame update = row % 7 == 3 ? no_data() : face({{12, row % 20 < 10 ? 0.6F : 0.1F}});
    EXPECT_TRUE(recording.add(row * 0.04, update));
    live.add(row * 0.04, update);
  }
  const auto stream = recording.finish();
  const auto keyframes = live.take();
  ASSERT_EQ(keyframes.size(), stream.keyframes.size());
  for (std::size_t index = 0; index < keyframes.size(); ++index) {
    EXPECT_EQ(keyframes[index].keyframe, stream.keyframes[index]) << index;
  }
}

TEST(Conditioning, LinesOfAStreamFileAreNotTouched) {
  ConditioningSettings settings;
  settings.profile.gain = PerAu(0);
  LiveTimeline live({}, settings);
  live.add(0, face({{12, 0.5F}}), 40);
  live.add(1, face({{12, 0.5F}}));
  const auto keyframes = live.take();
  ASSERT_EQ(keyframes.size(), 2U);
  EXPECT_EQ(keyframes[0].keyframe.terms, (std::vector<AuTerm>{{12, Side::Both, 50}}));
  EXPECT_EQ(keyframes[1].keyframe.terms, (std::vector<AuTerm>{{0, Side::Both, 100}}));
}

}  // namespace
}  // namespace aucast::sources
