#include "client/sound/sound_mixer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/sound/cranked_out.h"

namespace aucast::sound {
namespace {

using playback::Passing;
using test::CountingTrack;
using test::largest_step;
using test::ToneTrack;

constexpr std::size_t kTickSamples = 10 * kSamplesPerMs;
/// Of the tone at half volume, from sample to sample, and a little for the glides.
constexpr float kSmooth = 0.5F * 2 * 3.1416F / 240 + 0.006F;

/// What is heard of a tick that ends at `place`.
std::vector<float> tick(SoundMixer& mixer, std::optional<Passing> at_end) {
  std::vector<float> samples(kTickSamples);
  mixer.mix(at_end, samples);
  return samples;
}

void append(std::vector<float>& all, const std::vector<float>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

TEST(SoundMixer, CopiesSampleBySample) {
  CountingTrack track;
  SoundMixer mixer(track);
  (void)tick(mixer, Passing{Milliseconds(1010), 1});
  for (int i = 2; i < 100; ++i) {
    const auto samples = tick(mixer, Passing{Milliseconds(1000 + 10 * i), 1});
    for (std::size_t k = 0; k < kTickSamples; ++k) {
      const auto sample = static_cast<float>(48 * (990 + 10 * i) + static_cast<int>(k));
      ASSERT_EQ(samples[k], sample / CountingTrack::kWhole) << i << " " << k;
    }
  }
}

TEST(SoundMixer, IsNotDisturbedByTheRoundingOfMoments) {
  CountingTrack track;
  SoundMixer mixer(track);
  (void)tick(mixer, Passing{Milliseconds(1010), 1});
  for (int i = 2; i < 100; ++i) {
    const Duration wrong = std::chrono::nanoseconds(i % 2 == 0 ? 20'000 : -20'000);
    const auto samples = tick(mixer, Passing{Milliseconds(1000 + 10 * i) + wrong, 1});
    ASSERT_EQ(samples[0], static_cast<float>(48 * (990 + 10 * i)) / CountingTrack::kWhole) << i;
  }
}

TEST(SoundMixer, IsSilentWhileNothingPlays) {
  ToneTrack track;
  SoundMixer mixer(track);
  for (const auto passing : {std::optional<Passing>(), std::optional(Passing{Milliseconds(50), 0}),
                             std::optional(Passing{Milliseconds(50), 4})}) {
    for (const float sample : tick(mixer, passing)) EXPECT_EQ(sample, 0);
  }
}

TEST(SoundMixer, DoesNotClickWherePlayingStopsJumpsOrBegins) {
  ToneTrack track;
  SoundMixer mixer(track);
  std::vector<float> heard{0};
  int place = 1003;
  for (const int jump : {0, 500, 1, 7'003, -6'000, 77, 0, 13}) {
    for (int i = 0; i < 5; ++i) append(heard, tick(mixer, Passing{Milliseconds(place += 10), 1}));
    append(heard, tick(mixer, Passing{Milliseconds(place), 0}));
    for (int i = 0; i < 5; ++i) append(heard, tick(mixer, Passing{Milliseconds(place += 10), 1}));
    place += jump;
  }
  EXPECT_LT(largest_step(heard), kSmooth);
}

TEST(SoundMixer, ResamplesWithoutALossAndWithoutAClick) {
  for (const double speed : {0.5, 0.995, 1.005, 1.05, 2.0}) {
    ToneTrack track;
    SoundMixer mixer(track);
    std::vector<float> heard{0};
    double place_ms = 1000;
    for (int i = 0; i < 100; ++i) {
      place_ms += 10 * speed;
      append(heard, tick(mixer, Passing{Duration(std::llround(place_ms * 1e6)), speed}));
    }
    EXPECT_LT(largest_step(heard), kSmooth * static_cast<float>(std::max(1.0, speed))) << speed;
    // The tone, so much higher: it crosses zero so many times more often.
    int crossings = 0;
    for (std::size_t i = 1; i < heard.size(); ++i) crossings += heard[i - 1] < 0 && heard[i] >= 0;
    EXPECT_NEAR(crossings, 200 * speed, 1) << speed;
  }
}

TEST(SoundMixer, WaitsForAPlaceThatLiesALittleBack) {
  CountingTrack track;
  SoundMixer mixer(track);
  const double speed = 1.05;
  (void)tick(mixer, Passing{Milliseconds(1000), speed});
  std::vector<float> samples(4);
  mixer.mix(Passing{Milliseconds(1000) - std::chrono::microseconds(500), speed}, samples);
  // The last that was heard, until the place is reached again.
  for (const float sample : samples) EXPECT_EQ(sample, 47'999 / CountingTrack::kWhole);
  samples.resize(48);
  mixer.mix(Passing{Milliseconds(1001), speed}, samples);
  EXPECT_GE(samples.front(), 47'999 / CountingTrack::kWhole);
  EXPECT_LE(samples.back(), 48'048 / CountingTrack::kWhole);
}

TEST(SoundMixer, GoesFromOneSpeedToTheOtherWithoutAClick) {
  ToneTrack track;
  SoundMixer mixer(track);
  std::vector<float> heard{0};
  double place_ms = 1000;
  for (int i = 0; i < 100; ++i) {
    const double speed = i % 3 == 0 ? 1.005 : i % 3 == 1 ? 1 : 0.995;
    place_ms += 10 * speed;
    append(heard, tick(mixer, Passing{Duration(std::llround(place_ms * 1e6)), speed}));
  }
  EXPECT_LT(largest_step(heard), kSmooth);
}

TEST(SoundMixer, VolumeAndMuteComeWithoutAClick) {
  ToneTrack track;
  SoundMixer mixer(track);
  std::vector<float> heard{0};
  int place = 1000;
  const auto play = [&] {
    for (int i = 0; i < 5; ++i) append(heard, tick(mixer, Passing{Milliseconds(place += 10), 1}));
  };
  play();
  mixer.set_volume(50);
  play();
  EXPECT_NEAR(*std::max_element(heard.end() - kTickSamples, heard.end()), 0.5F / 8, 0.001F);
  mixer.set_muted(true);
  play();
  EXPECT_EQ(heard.back(), 0);
  EXPECT_NEAR(mixer.peak(), 0.5F, 0.05F) << "the peak is that of what comes";
  mixer.set_muted(false);
  play();
  EXPECT_NEAR(*std::max_element(heard.end() - kTickSamples, heard.end()), 0.5F / 8, 0.001F);
  EXPECT_LT(largest_step(heard), kSmooth);
}

TEST(SoundMixer, TheLevelFallsWithSilence) {
  ToneTrack track;
  SoundMixer mixer(track);
  for (int i = 0; i < 10; ++i) (void)tick(mixer, Passing{Milliseconds(1000 + 10 * i), 1});
  const float loud = mixer.peak();
  EXPECT_NEAR(loud, 0.5F, 0.05F);
  for (int i = 0; i < 100; ++i) (void)tick(mixer, std::nullopt);
  EXPECT_LT(mixer.peak(), loud / 10);
}

}  // namespace
}  // namespace aucast::sound
