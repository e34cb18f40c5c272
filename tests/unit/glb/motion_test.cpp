#include "client/glb/motion.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace aucast::glb
