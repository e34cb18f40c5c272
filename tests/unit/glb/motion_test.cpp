#include "client/glb/motion.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/face/co_occurrence_rules.h"
#include "tests/support/seeded.h"
#include "tests/unit/face/small_face.h"

namespace aucast::glb {
namespace {

using face::test::small_face;

playback::Keyframe keyframe(std::uint8_t au, float intensity,
                            std::optional<Milliseconds> duration) {
  playback::Keyframe keyframe;
  set_intensity(keyframe.aus, au, Side::Both, intensity);
  keyframe.time = duration;
  return keyframe;
}

struct Sample {
  double seconds = 0;
  float intensity = 0;
};

std::vector<Sample> samples(const std::vector<playback::Keyframe>& keyframes, int fps) {
  const face::Face face = small_face();
  const pipeline::AuMapping mapping{face, face.recordings, {}, face::Mixer::Maximum};
  std::vector<Sample> all;
  const Sampling sampling{.fps = fps, .untimed = Milliseconds(100)};
  for_each_sample(mapping, keyframes, sampling,
                  [&](double seconds, const pipeline::FaceState& state) {
                    all.push_back({seconds, state.aus.left[12]});
                    return true;
                  });
  EXPECT_EQ(all.size(), sample_count(keyframes, sampling));
  return all;
}

TEST(ForEachSample, GoesFromNeutralToTheEndOfTheLastKeyframe) {
  const auto all =
      samples({keyframe(12, 1, Milliseconds(200)), keyframe(12, 0.5F, std::nullopt)}, 10);
  ASSERT_EQ(all.size(), 4U);
  const std::array<float, 4> expected{0, 0.5F, 1, 0.5F};
  for (std::size_t n = 0; n < all.size(); ++n) {
    EXPECT_DOUBLE_EQ(all[n].seconds, static_cast<double>(n) / 10);
    EXPECT_NEAR(all[n].intensity, expected[n], 1e-6F);
  }
}

TEST(ForEachSample, AKeyframeWithoutTimeIsReachedAtOnceAndNothingIsSkipped) {
  const auto all = samples({keyframe(12, 1, Milliseconds(0)), keyframe(12, 1, Milliseconds(50)),
                            keyframe(12, 0, Milliseconds(50))},
                           20);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_FLOAT_EQ(all[1].intensity, 1);
  EXPECT_FLOAT_EQ(all[2].intensity, 0);
}

TEST(ForEachSample, BlinksComeOnTop) {
  const face::Face face = small_face();
  const pipeline::AuMapping mapping{face, face.recordings, {}, face::Mixer::Maximum};
  Sampling sampling{.fps = 30};
  sampling.idle.blink = playback::BlinkOptions{1};
  float closed = 0;
  for_each_sample(mapping, std::vector{keyframe(12, 1, Milliseconds(20'000))}, sampling,
                  [&](double, const pipeline::FaceState& state) {
                    closed =
                        std::max(closed, state.activations[*face.channel_index("left_lid_close")]);
                    return true;
                  });
  EXPECT_GT(closed, 0.5F);
}

TEST(ForEachSample, EndsWhereItIsToldTo) {
  const face::Face face = small_face();
  const pipeline::AuMapping mapping{face, face.recordings, {}, face::Mixer::Maximum};
  int seen = 0;
  const auto three = [&seen](double, const pipeline::FaceState&) { return ++seen < 3; };
  const std::vector keyframes{keyframe(12, 1, Milliseconds(500)),
                              keyframe(12, 0, Milliseconds(500))};
  for_each_sample(mapping, keyframes, {}, three);
  EXPECT_EQ(seen, 3);
}

TEST(ForEachSample, CountsAsManyAsItMakesWhateverTheTimes) {
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 50; ++round) {
    std::vector<playback::Keyframe> keyframes;
    std::int64_t all_ms = 0;
    for (int n = seeded.integer(1, 12); n > 0; --n) {
      const int ms = seeded.integer(0, 3) == 0 ? 0 : seeded.integer(1, 400);
      keyframes.push_back(keyframe(12, static_cast<float>(n % 2), Milliseconds(ms)));
      all_ms += ms;
    }
    const int fps = seeded.integer(1, 240);
    const auto all = samples(keyframes, fps);  // which counts them
    ASSERT_FALSE(all.empty());
    EXPECT_LE(all.back().seconds * 1000, static_cast<double>(all_ms) + 1e-6);
    EXPECT_GT((all.back().seconds + 1.0 / fps) * 1000, static_cast<double>(all_ms));
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_GT(all[i].seconds, all[i - 1].seconds);
  }
}

TEST(ForEachSample, ByCosineItBeginsAndEndsSlowly) {
  const face::Face face = small_face();
  const pipeline::AuMapping mapping{face, face.recordings, {}, face::Mixer::Maximum};
  const auto at_quarter = [&](playback::Interpolation kind) {
    float seen = 0;
    for_each_sample(mapping, std::vector{keyframe(12, 1, Milliseconds(400))},
                    {.fps = 10, .interpolation = kind},
                    [&](double seconds, const pipeline::FaceState& state) {
                      if (std::abs(seconds - 0.1) < 1e-6) {
                        seen = state.activations[*face.channel_index("left_zygomaticus_major")];
                      }
                      return true;
                    });
    return seen;
  };
  EXPECT_NEAR(at_quarter(playback::Interpolation::Linear), 1.5F / 4, 1e-4F);
  EXPECT_NEAR(at_quarter(playback::Interpolation::Cosine), 1.5F * 0.1464F, 1e-3F);
}

TEST(ForEachSample, RulesApplyAsInPlaying) {
  const face::Face face = small_face();
  face::RuleSet rules;
  rules.rules = {
      {.kind = face::RuleKind::Exclusion, .sources = {26}, .targets = {12}, .source = {}}};
  const pipeline::AuMapping mapping{face, face.recordings, std::move(rules), face::Mixer::Maximum};
  playback::Keyframe both = keyframe(12, 1, Milliseconds(100));
  set_intensity(both.aus, 26, Side::Both, 1);
  float smile = 1;
  for_each_sample(mapping, std::vector{both}, {.fps = 10},
                  [&](double, const pipeline::FaceState& state) {
                    smile = state.activations[*face.channel_index("left_zygomaticus_major")];
                    return true;
                  });
  EXPECT_EQ(smile, 0);
}

}  // namespace
}  // namespace aucast::glb
