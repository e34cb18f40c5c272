#include "client/sound/sound_player.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "client/playback/playback.h"
#include "client/playback/source_playback.h"
#include "tests/unit/playback/scripted_source.h"
#include "tests/unit/sound/cranked_out.h"

namespace aucast::sound {
namespace {

using playback::EndReason;
using playback::Keyframe;
using playback::PlaybackState;
using playback::SourcePlayback;
using test::CountingTrack;
using test::Crank;
using test::CrankedOut;
using test::largest_step;
using test::ToneTrack;

constexpr Milliseconds kTick{10};

/// A stream of keyframes of 40 ms, a device that the test cranks, and the player between them.
class SoundPlayerTest : public ::testing::Test {
 protected:
  SoundPlayerTest() {
    auto source = std::make_unique<playback::test::ScriptedSource>();
    source_ = source.get();
    playback_ = std::make_unique<SourcePlayback>(std::move(source), SourcePlayback::Options{});
  }

  void keyframes(int count) {
    for (int i = 0; i < count; ++i) {
      Keyframe keyframe;
      keyframe.time = Milliseconds(40);
      keyframe.place = place_ += Milliseconds(40);
      keyframe.span = Milliseconds(40);
      source_->keyframes.push_back(keyframe);
    }
  }

  /// One picture's time, for the device `device_time` of it.
  void tick(Duration device_time = kTick) {
    steady_ += kTick;
    crank_.turn(device_time);
    const Instant now = player_.now(steady_);
    EXPECT_GE(now, std::exchange(last_now_, now));
    EXPECT_LE(player_.shown(), now);
    while (playback_->advance(now)) {
    }
    player_.advanced();
    player_.face_shown();
  }
  void ticks(int count, Duration device_time = kTick) {
    for (int i = 0; i < count; ++i) tick(device_time);
  }

  /// The place of the counting track that the device is at.
  [[nodiscard]] double heard_ms() const {
    const float sample = crank_.written.at(static_cast<std::size_t>(crank_.heard) - 1);
    return std::round(static_cast<double>(sample * CountingTrack::kWhole)) / kSamplesPerMs;
  }
  /// The place of the face that is shown: it was at `passing` at now().
  [[nodiscard]] double shown_ms() {
    const auto passing = playback_->passing();
    return 1000 * (seconds(passing->place) - seconds(player_.now(steady_) - player_.shown()));
  }

  Crank crank_;
  SoundPlayer player_{std::make_unique<CrankedOut>(crank_)};
  playback::test::ScriptedSource* source_ = nullptr;
  std::unique_ptr<SourcePlayback> playback_;
  CountingTrack counting_;
  ToneTrack tone_;
  Milliseconds place_{0};
  Instant steady_{std::chrono::hours(1)};
  Instant last_now_{};
};

TEST_F(SoundPlayerTest, WithoutSoundTheClockIsTheSteadyOne) {
  player_.open(playback_.get());
  for (int i = 0; i < 100; ++i) {
    steady_ += kTick;
    EXPECT_EQ(player_.now(steady_), steady_);
    EXPECT_EQ(player_.shown(), steady_);
    player_.advanced();
  }
  EXPECT_FALSE(player_.sounds());
  EXPECT_TRUE(crank_.written.empty());
}

TEST_F(SoundPlayerTest, GoesOnHoweverOftenThePlayerItselfWasHeldUp) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(100);
  for (int i = 0; i < 20; ++i) {
    const std::size_t before = crank_.written.size();
    steady_ += std::chrono::seconds(1);
    ticks(1, std::chrono::seconds(1));  // the device has played all it had
    ticks(20);
    EXPECT_GT(crank_.written.size(), before) << i;
  }
  EXPECT_FALSE(player_.take_loss());
  ticks(100);
  EXPECT_NEAR(shown_ms(), heard_ms(), 1);
}

TEST_F(SoundPlayerTest, ADeviceThatComesLaterGoesOnFromThere) {
  player_ = SoundPlayer(nullptr);
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(100);
  EXPECT_TRUE(crank_.written.empty());
  player_.set_out(std::make_unique<CrankedOut>(crank_));
  ticks(100);
  ASSERT_TRUE(player_.sounds());
  EXPECT_NEAR(shown_ms(), heard_ms(), 1);
  EXPECT_GT(heard_ms(), 1500);

  player_.set_out(nullptr);
  ticks(10);
  EXPECT_FALSE(player_.sounds());
  EXPECT_EQ(player_.shown(), last_now_);
  crank_ = {};
  player_.set_out(std::make_unique<CrankedOut>(crank_));
  ticks(100);
  EXPECT_NEAR(shown_ms(), heard_ms(), 1);
}

TEST_F(SoundPlayerTest, TheFaceShownIsThatOfTheSampleHeard) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(100);
  for (int i = 0; i < 1000; ++i) {
    tick();
    ASSERT_NEAR(shown_ms(), heard_ms(), 1) << i;
  }
  const ShiftSummary shift = player_.counts().shift;
  EXPECT_GT(shift.count, 900U);
  EXPECT_NEAR(seconds(shift.median), 0, 0.001);
}

TEST_F(SoundPlayerTest, TheSoundIsTheClockWhateverItsPace) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(100);
  const double before = shown_ms();
  // A device that is a thousandth fast.
  ticks(1500, std::chrono::microseconds(10'010));
  EXPECT_NEAR(shown_ms() - before, 15'015, 3);
  EXPECT_NEAR(shown_ms(), heard_ms(), 3);
  ASSERT_TRUE(player_.counts().drift_ppm.has_value());
  EXPECT_NEAR(*player_.counts().drift_ppm, 1000, 100);
}

TEST_F(SoundPlayerTest, ADeviceThatSleepsAtFirstHoldsTheFace) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(150, Duration::zero());
  EXPECT_LE(shown_ms(), 0.001);
  ticks(200);
  EXPECT_NEAR(shown_ms(), heard_ms(), 1);
}

TEST_F(SoundPlayerTest, NothingIsLostOrHeardTwiceByAStall) {
  player_.open(playback_.get(), &counting_);
  keyframes(50);
  ticks(300);
  EXPECT_EQ(playback_->state(), PlaybackState::Stalled);
  keyframes(50);
  ticks(150);
  EXPECT_NEAR(shown_ms(), heard_ms(), 1);
  // Each place is heard once, but for the glides.
  std::vector<int> times(3000);
  for (const float sample : crank_.written) {
    const long ms = std::lround(sample * CountingTrack::kWhole) / kSamplesPerMs;
    if (ms >= 1 && ms < 3000) ++times[static_cast<std::size_t>(ms)];
  }
  for (std::size_t ms = 10; ms < 2900; ++ms) {
    if (ms > 1975 && ms < 2015) continue;
    EXPECT_NEAR(times[ms], kSamplesPerMs, 2) << ms;
  }
}

TEST_F(SoundPlayerTest, PausesSeeksOfTheClockAndStallsDoNotClick) {
  player_.open(playback_.get(), &tone_);
  keyframes(100);
  ticks(100);
  for (int i = 0; i < 5; ++i) {
    playback_->pause(player_.now(steady_));
    ticks(17);
    playback_->resume(player_.now(steady_));
    ticks(23);
  }
  place_ += Milliseconds(12'345);
  keyframes(200);
  ticks(400);
  EXPECT_LT(largest_step(crank_.written), 0.02F);
}

TEST_F(SoundPlayerTest, AfterAPauseFaceAndSoundAreTogether) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(150);
  playback_->pause(player_.now(steady_));
  ticks(100);
  playback_->resume(player_.now(steady_));
  ticks(100);
  EXPECT_NEAR(shown_ms(), heard_ms(), 1);
}

TEST_F(SoundPlayerTest, RunningOutOfSoundIsCountedAndTheLeadGrows) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(100);
  // The player comes too late: the device has played all it was given.
  steady_ += Milliseconds(300);
  crank_.turn(Milliseconds(300));
  tick();
  ticks(150);
  EXPECT_EQ(player_.counts().underruns, 1U);
  EXPECT_NEAR(seconds(player_.now(steady_) - player_.shown()), 0.150, 0.002);
  EXPECT_NEAR(shown_ms(), heard_ms(), 2);
}

TEST_F(SoundPlayerTest, ALostDeviceLeavesTheSteadyClock) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(100);
  crank_.lost = true;
  tick();
  EXPECT_TRUE(player_.take_loss());
  EXPECT_FALSE(player_.take_loss());
  EXPECT_FALSE(player_.sounds());
  const Instant before = player_.now(steady_);
  ticks(100);
  EXPECT_EQ(player_.now(steady_) - before, 100 * kTick);
}

TEST_F(SoundPlayerTest, ADeviceThatPlaysNothingIsGivenUp) {
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(1 + static_cast<int>(HeardOut::kDeafMax / kTick), Duration::zero());
  EXPECT_FALSE(player_.take_loss());
  tick(Duration::zero());
  EXPECT_TRUE(player_.take_loss());
  ticks(100);
  EXPECT_GT(shown_ms(), 900);
}

TEST_F(SoundPlayerTest, SoundThatOutlastsTheFaceIsPlayedToItsEnd) {
  struct Short final : SoundTrack {
    void read(std::int64_t /*begin*/, std::span<float> samples) override {
      std::fill(samples.begin(), samples.end(), 0.1F);
    }
    [[nodiscard]] std::int64_t end() const override { return 3000 * kSamplesPerMs; }
  } track;
  player_.open(playback_.get(), &track);
  keyframes(50);
  source_->now.end = EndReason::EndOfStream;
  ticks(250);
  EXPECT_TRUE(playback_->over());
  EXPECT_TRUE(player_.rings_on());
  ticks(80);
  EXPECT_FALSE(player_.rings_on());
}

TEST_F(SoundPlayerTest, ThereIsNoLevelWhenNothingPlaysAnyMore) {
  struct Second final : SoundTrack {
    void read(std::int64_t /*begin*/, std::span<float> samples) override {
      std::fill(samples.begin(), samples.end(), 0.5F);
    }
    [[nodiscard]] std::int64_t end() const override { return 1000 * kSamplesPerMs; }
  } track;
  player_.open(playback_.get(), &track);
  keyframes(25);
  source_->now.end = EndReason::EndOfStream;
  ticks(50);
  EXPECT_GT(player_.peak(), 0.4F);
  ticks(100);
  EXPECT_FALSE(player_.sounds());
  EXPECT_EQ(player_.peak(), 0);
}

TEST_F(SoundPlayerTest, LiveKeyframesAreDueByTheClockOfTheSound) {
  player_.open(playback_.get(), &counting_);
  keyframes(50);
  ticks(100);
  // The device has been given 100 ms ahead, so that what arrives now is shown 100 ms later.
  for (int i = 0; i < 20; ++i) {
    Keyframe keyframe;
    keyframe.time = Milliseconds(40);
    keyframe.place = place_ += Milliseconds(40);
    keyframe.span = Milliseconds(40);
    keyframe.arrived = steady_;
    source_->keyframes.push_back(keyframe);
  }
  ticks(200);
  ASSERT_GT(playback_->delays().all().keyframes, 0U);
  EXPECT_GE(playback_->delays().all().median, HeardOut::kLeadMin);
}

TEST_F(SoundPlayerTest, WhatIsWrittenGoesToTheTapWithWhenItIsHeard) {
  std::vector<std::pair<Instant, std::size_t>> tapped;
  std::int64_t first = 0;
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  ticks(200);
  first = static_cast<std::int64_t>(crank_.written.size());
  player_.set_tap([&](Instant heard_at, std::span<const float> samples) {
    tapped.emplace_back(heard_at, samples.size());
  });
  ticks(50);
  player_.set_tap({});
  ticks(10);
  ASSERT_GT(tapped.size(), 40U);
  std::int64_t sample = first;
  for (const auto& [heard_at, count] : tapped) {
    // The crank turns as fast as the steady clock does.
    const Duration until = std::chrono::nanoseconds((sample - crank_.heard) * 1'000'000 / 48);
    EXPECT_NEAR(seconds(heard_at - steady_), seconds(until), 0.002);
    sample += static_cast<std::int64_t>(count);
  }
  EXPECT_LT(sample, static_cast<std::int64_t>(crank_.written.size()));
}

TEST_F(SoundPlayerTest, TheTapHasTheFadeOfAStopToo) {
  std::vector<std::pair<Instant, std::size_t>> tapped;
  std::size_t samples_tapped = 0;
  player_.open(playback_.get(), &counting_);
  keyframes(1000);
  player_.set_tap([&](Instant heard_at, std::span<const float> samples) {
    tapped.emplace_back(heard_at, samples.size());
    samples_tapped += samples.size();
  });
  ticks(50);
  player_.open(playback_.get(), &counting_);
  EXPECT_EQ(samples_tapped, crank_.written.size());
  ticks(50);
  crank_.lost = true;
  tick();
  ASSERT_FALSE(player_.sounds());
  ASSERT_EQ(samples_tapped, crank_.written.size());
  const auto fade = static_cast<std::int64_t>(tapped.back().second);
  const auto before = static_cast<std::int64_t>(samples_tapped) - fade - crank_.heard;
  EXPECT_NEAR(seconds(tapped.back().first - steady_), static_cast<double>(before) / kRate, 0.002);
}

}  // namespace
}  // namespace aucast::sound
