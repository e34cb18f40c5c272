#include "common/sources/profile.h"

#include <gtest/gtest.h>

namespace aucast::sources {
namespace {

Profile parsed(std::string_view text) {
  const auto profile = parse_profile(text, "p.toml");
  if (!profile) {
    ADD_FAILURE() << profile.error().message;
    return {};
  }
  return *profile;
}

std::string profile_error(std::string_view text) {
  const auto profile = parse_profile(text, "p.toml");
  if (profile) return "accepted";
  EXPECT_EQ(profile.error().kind, ErrorKind::BadData);
  return profile.error().message;
}

TEST(Profile, AnEmptyOneIsTheDefault) {
  const Profile profile = parsed("");
  EXPECT_EQ(profile.gain, PerAu(1));
  EXPECT_EQ(profile.dead_band, PerAu(2));
  EXPECT_FALSE(profile.filter);
  for (const float signal : profile.neutral) EXPECT_FALSE(is_signal(signal));
}

TEST(Profile, IsReadByTables) {
  const Profile profile = parsed(
      "[neutral]\n4 = 12.5\nL12 = 10\nR12 = 5\n52 = 150\ndistance-mm = 420\n"
      "[gain]\n45 = 1.6\nall = 1.2  # wherever it stands\n"
      "[dead-band]\nR12 = 4\n"
      "[filter]\nmin-cutoff = 0.5\n");
  EXPECT_FLOAT_EQ(profile.neutral[channel_of(4, true)], 0.125F);
  EXPECT_FLOAT_EQ(profile.neutral[channel_of(12, false)], 0.1F);
  EXPECT_FLOAT_EQ(profile.neutral[channel_of(12, true)], 0.05F);
  EXPECT_FLOAT_EQ(profile.neutral[channel_of(51, false)], -1.5F);
  EXPECT_FLOAT_EQ(profile.neutral[channel_of(57, true)], -30);
  EXPECT_EQ(profile.gain.of(45, false), 1.6);
  EXPECT_EQ(profile.gain.of(12, false), 1.2);
  EXPECT_EQ(profile.dead_band.of(12, true), 4);
  EXPECT_EQ(profile.dead_band.of(12, false), 2);
  EXPECT_EQ(profile.filter, (OneEuroSettings{0.5, 5, 1}));
}

TEST(Profile, GoesThereAndBack) {
  Profile profile;
  profile.neutral[channel_of(4, false)] = profile.neutral[channel_of(4, true)] = 0.123456F;
  profile.neutral[channel_of(12, false)] = 0.5F;
  profile.neutral[channel_of(12, true)] = 0.25F;
  profile.neutral[channel_of(53, false)] = profile.neutral[channel_of(53, true)] = -0.655F;
  profile.neutral[channel_of(57, false)] = profile.neutral[channel_of(57, true)] = -18.317F;
  profile.gain = PerAu(1.25);
  profile.gain.set({45, Side::Both}, 1.6);
  profile.dead_band.set({12, Side::Left}, 5);
  profile.filter = OneEuroSettings{0.7, 2.5, 1.5};
  const std::string text = format_profile(profile);
  const Profile again = parsed(text);
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    const double known = is_signal(profile.neutral[channel]) ? profile.neutral[channel] : 0;
    const double read = is_signal(again.neutral[channel]) ? again.neutral[channel] : 0;
    EXPECT_NEAR(read, known, channel % kAuCount == 57 ? 0.005 : 0.00005) << channel;
  }
  EXPECT_EQ(again.gain, profile.gain);
  EXPECT_EQ(again.dead_band, profile.dead_band);
  EXPECT_EQ(again.filter, profile.filter);
  EXPECT_EQ(format_profile(again), text);
}

TEST(Profile, ErrorsNameThePlace) {
  EXPECT_TRUE(profile_error("[neutral\n").starts_with("p.toml:1:"));
  EXPECT_EQ(profile_error("[gian]\n1 = 2\n"),
            "p.toml:1:2: 'gian' is none of a profile's tables; did you mean 'gain'?");
  EXPECT_EQ(profile_error("gain = 2\n"), "p.toml:1:8: gain is not a table");
  EXPECT_EQ(profile_error("[gain]\n12 = '2'\n"), "p.toml:2:6: 12 is not a number");
  EXPECT_EQ(profile_error("[gain]\n12 = 11\n"), "p.toml:2:6: 12 is not from 0 to 10");
  EXPECT_EQ(profile_error("[gain]\n12 = nan\n"), "p.toml:2:6: 12 is not from 0 to 10");
  EXPECT_EQ(profile_error("[gain]\nal = 1\n"),
            "p.toml:2:1: 'al' is no AU, such as 12 or L12; did you mean 'all'?");
  EXPECT_EQ(profile_error("[dead-band]\n12 = 1.5\n"), "p.toml:2:6: is not whole percent");
  EXPECT_EQ(profile_error("[neutral]\n0 = 1\n"), "p.toml:2:1: '0' is no AU, such as 12 or L12");
  EXPECT_EQ(profile_error("[neutral]\n12 = -1\n"), "p.toml:2:6: 12 is not from 0 to 1000");
  EXPECT_EQ(profile_error("[neutral]\n51 = 1\n52 = 1\n"),
            "p.toml:3:1: AU 51 or its opposite is there already");
  EXPECT_EQ(profile_error("[neutral]\nR12 = 1\n12 = 1\n"), "p.toml:3:1: AU 12 is there already");
  EXPECT_EQ(profile_error("[neutral]\n58 = 1\n"),
            "p.toml:2:1: the distance is said as distance-mm");
  EXPECT_EQ(profile_error("[filter]\nmin-cutoff = 0\n"), "p.toml:2:14: min-cutoff is 0");
  EXPECT_EQ(profile_error("[filter]\nbeta = 0\n"), "accepted");
  EXPECT_EQ(profile_error("[filter]\nmincutoff = 1\n"),
            "p.toml:2:1: 'mincutoff' is none of the filter's; did you mean 'min-cutoff'?");
}

TEST(Profile, WhatWasMeasuredIsSaid) {
  MeasuredNeutral measured;
  measured.seconds = 2;
  EXPECT_EQ(measured_text(measured), "not measured: there is no data");
  measured.rows = 60;
  EXPECT_EQ(measured_text(measured), "measured in 60 rows of 2 s: nothing over 1 %");
  measured.signals[channel_of(12, false)] = 0.084F;
  measured.signals[channel_of(51, false)] = measured.signals[channel_of(51, true)] = -0.2F;
  EXPECT_EQ(measured_text(measured), "measured in 60 rows of 2 s: L12 8 %, 52 20 %");
}

}  // namespace
}  // namespace aucast::sources
