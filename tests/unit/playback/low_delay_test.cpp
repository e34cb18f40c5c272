// --live from arrival to face: playout, buffers and playback together over links of every kind.
#include <algorithm>
#include <cmath>
#include <deque>

#include <gtest/gtest.h>

#include "client/playback/interpolator.h"
#include "client/playback/keyframe_buffers.h"
#include "client/playback/live_playout.h"
#include "client/playback/source_playback.h"
#include "tests/support/manual_clock.h"
#include "tests/support/seeded.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using aucast::test::Seeded;
using test::borrow;
using test::mark_of;
using test::marked;

BufferOptions low_delay() {
  BufferOptions options;
  options.low_delay = true;
  return options;
}

/// What the network thread makes of a live stream: keyframes that say when they came and are due.
class LinkSource final : public KeyframeSource {
 public:
  explicit LinkSource(Milliseconds time) : time_(time) { buffers_.set_live(true); }

  void arrive(Instant now) {
    Keyframe keyframe = marked(++sent_, time_);
    keyframe.arrived = now;
    keyframe.due = playout_.arrived(now, time_);
    EXPECT_EQ(buffers_.store(keyframe), KeyframeBuffers::Stored::Yes);
  }

  [[nodiscard]] std::optional<Keyframe> take() override { return buffers_.take(); }
  [[nodiscard]] bool ready() const override { return buffers_.has_next(); }
  bool wait_until(Instant /*until*/) override { return ready(); }
  [[nodiscard]] SourceStatus status() const override { return {}; }
  void stop() override {}
  [[nodiscard]] std::uint64_t dropped() const { return buffers_.dropped(); }

 private:
  Milliseconds time_;
  LivePlayout playout_;
  KeyframeBuffers buffers_{low_delay()};
  int sent_ = 0;
};

/// A live stream being watched. Looks at the face every millisecond and checks each time that it
/// goes on in order, no faster and no slower than 5 % from its own speed, and never beyond.
class Watching {
 public:
  explicit Watching(Milliseconds time) : time_(time), source_(time) {}

  /// Sends for so long; `late` gives how late each keyframe comes.
  template <typename Late>
  void send(Duration how_long, const Late& late) {
    const Instant end = now_ + how_long;
    while (now_ < end) {
      if (now_ >= next_sent_) {
        const Instant before = under_way_.empty() ? now_ : under_way_.back();
        under_way_.push_back(std::max(before, next_sent_ + late()));
        next_sent_ += time_;
      }
      while (!under_way_.empty() && under_way_.front() <= now_) {
        source_.arrive(under_way_.front());
        under_way_.pop_front();
      }
      look();
      now_ += 1ms;
    }
  }

  [[nodiscard]] DelaySummary lately() const { return playback_.delays().lately(); }
  [[nodiscard]] const SourcePlayback& playback() const { return playback_; }
  [[nodiscard]] std::uint64_t dropped() const { return source_.dropped(); }

 private:
  void look() {
    while (const auto begun = playback_.advance(now_)) {
      EXPECT_GT(mark_of(begun->target), last_mark_);
      last_mark_ = mark_of(begun->target);
      EXPECT_EQ(begun->time, time_);
      from_ = to_;
      to_ = static_cast<float>(last_mark_ % 2);
      before_ = -1;
    }
    const PlaybackProgress progress = playback_.progress();
    if (progress.keyframe == 0) return;
    if (before_ >= 0 && progress.mu < 1) {
      const double own = 1.0 / static_cast<double>(time_.count());  // in a millisecond
      EXPECT_GE(progress.mu - before_, own / 1.051);
      EXPECT_LE(progress.mu - before_, own / 0.949);
    }
    before_ = progress.mu;
    float shown = 0;
    interpolate({&from_, 1}, {&to_, 1}, ease(Interpolation::Cosine, progress.mu), {&shown, 1});
    EXPECT_GE(shown, std::min(from_, to_));
    EXPECT_LE(shown, std::max(from_, to_));
  }

  Milliseconds time_;
  LinkSource source_;
  SourcePlayback playback_{borrow(source_), {}};
  Instant now_ = ManualClock().now();
  Instant next_sent_ = now_;
  std::deque<Instant> under_way_;
  int last_mark_ = 0;
  double before_ = -1;
  float from_ = 0;
  float to_ = 0;
};

constexpr auto kInTime = [] { return Duration(0ms); };

TEST(LowDelay, IsOneKeyframeOnALinkWithoutJitter) {
  Watching watching(40ms);
  watching.send(10s, kInTime);
  EXPECT_LE(watching.lately().median, 43ms);
  EXPECT_LE(watching.lately().longest, 43ms);
  EXPECT_EQ(watching.playback().stalls(), 0U);
  EXPECT_EQ(watching.dropped(), 0U);
}

TEST(LowDelay, IsThereWithinSecondsWhoeverJoinsWhen) {
  Watching watching(100ms);
  bool first = true;
  watching.send(5s, [&] { return std::exchange(first, false) ? Duration(90ms) : Duration(0ms); });
  watching.send(20s, kInTime);
  EXPECT_LE(watching.lately().median, 103ms);
}

TEST(LowDelay, CatchesUpAfterAnOutageWithoutAJump) {
  Watching watching(40ms);
  watching.send(20s, kInTime);
  const Duration outage = 1s;
  // One is lost, and all behind it come together with it.
  bool lost = true;
  watching.send(1s, [&] { return std::exchange(lost, false) ? outage : Duration(0ms); });
  EXPECT_EQ(watching.playback().stalls(), 1U);
  watching.send(4s, kInTime);
  EXPECT_GT(watching.dropped(), 10U) << "the face stood: what is past is left out";
  watching.send(11s, kInTime);
  EXPECT_LE(watching.lately().median, 44ms);
  EXPECT_LE(watching.lately().longest, 44ms) << "for ten seconds";
  EXPECT_EQ(watching.playback().stalls(), 1U);
}

TEST(LowDelay, FollowsJitterOfEveryKind) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 20; ++run) {
    const Milliseconds time(seeded.integer(8, 120));
    const int jitter_us = seeded.integer(0, 100'000);
    SCOPED_TRACE(::testing::Message() << time.count() << " ms, jitter " << jitter_us << " us");
    Watching watching(time);
    const auto late = [&] { return Duration(seeded.integer(0, jitter_us) * 1us); };
    watching.send(60s, late);
    const std::uint64_t stalls = watching.playback().stalls();
    watching.send(60s, late);
    EXPECT_LE(watching.lately().median, time + jitter_us * 1us + 5ms);
    EXPECT_LE(watching.playback().stalls() - stalls, 4U) << "in a minute";
  }
}

/// However bad it is: the checks of every look hold, and it is as near as 5 % allow.
TEST(LowDelay, KeepsItsRulesOverAWildLink) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 10; ++run) {
    Watching watching(Milliseconds(seeded.integer(5, 150)));
    for (int part = 0; part < 20; ++part) {
      const int jitter_us = seeded.integer(0, 300'000);
      const double outages = seeded.chance(0.3) ? 0.01 : 0;
      watching.send(Milliseconds(seeded.integer(100, 5000)), [&] {
        const int lost_ms = seeded.chance(outages) ? seeded.integer(200, 3000) : 0;
        return Duration(seeded.integer(0, jitter_us) * 1us + lost_ms * 1ms);
      });
    }
    EXPECT_GT(watching.playback().keyframes_played(), 10U);
  }
}

TEST(LowDelay, AWaitThatNobodySeesIsNoStall) {
  for (const auto& [wait, stalls] : {std::pair(19ms, 0U), std::pair(20ms, 1U)}) {
    LinkSource source(40ms);
    SourcePlayback playback(borrow(source), {});
    Instant now = ManualClock().now();
    source.arrive(now);
    EXPECT_TRUE(playback.advance(now));
    now += 42ms;
    EXPECT_FALSE(playback.advance(now));
    EXPECT_EQ(playback.progress().mu, 1.0);
    EXPECT_FALSE(playback.next_position_at());
    EXPECT_EQ(playback.state(), PlaybackState::Playing);
    now += wait;
    EXPECT_FALSE(playback.advance(now));
    EXPECT_EQ(playback.state(), stalls == 1 ? PlaybackState::Stalled : PlaybackState::Playing);
    source.arrive(now);
    EXPECT_TRUE(playback.advance(now));
    EXPECT_EQ(playback.state(), PlaybackState::Playing);
    EXPECT_EQ(playback.stalls(), stalls);
  }
}

/// A slow display makes the face late by the time between two of its frames, and by no more.
TEST(LowDelay, DoesNotGrowWhereTheFaceIsSeldomLookedAt) {
  LinkSource source(40ms);
  SourcePlayback playback(borrow(source), {});
  Instant now = ManualClock().now();
  for (int i = 0; i < 2000; ++i, now += 40ms) {
    source.arrive(now);
    if (i % 8 != 7) continue;
    while (playback.advance(now + 1ms)) {
    }
  }
  EXPECT_LE(playback.delays().lately().longest, 42ms + 8 * 40ms + 1ms);
  EXPECT_LE(playback.delays().lately().median, 250ms);
}

TEST(LowDelay, WhatCameWhileTheUserPausedBeginsNow) {
  LinkSource source(40ms);
  SourcePlayback playback(borrow(source), {});
  Instant now = ManualClock().now();
  source.arrive(now);
  EXPECT_TRUE(playback.advance(now));
  now += 50ms;
  EXPECT_FALSE(playback.advance(now));
  playback.pause(now);
  source.arrive(now + 5ms);
  now += 10s;
  playback.resume(now);
  EXPECT_TRUE(playback.advance(now));
  EXPECT_EQ(playback.progress().mu, 0.0) << "and not long ago";
}

TEST(LowDelay, CountsFromTheArrivalToTheFace) {
  LinkSource source(40ms);
  SourcePlayback playback(borrow(source), {});
  Instant now = ManualClock().now();
  source.arrive(now);
  now += 5ms;
  EXPECT_TRUE(playback.advance(now));
  now += 50ms;
  EXPECT_FALSE(playback.advance(now));
  EXPECT_EQ(playback.delays().all().longest, 55ms) << "seen by the call, not by the clock";
  EXPECT_EQ(playback.delays_meant().all().median, 42ms);
}

TEST(LowDelay, APauseBeforeTheUserLeavesIsNoDelay) {
  LinkSource source(40ms);
  SourcePlayback playback(borrow(source), {});
  Instant now = ManualClock().now();
  source.arrive(now);
  EXPECT_TRUE(playback.advance(now));
  now += 50ms;
  playback.pause(now);
  playback.stop(now + 1h);
  EXPECT_EQ(playback.keyframes_played(), 1U);
  EXPECT_EQ(playback.delays().all().longest, 50ms);
}

TEST(LowDelay, OnTheVideoClockIsNone) {
  LinkSource source(40ms);
  SourcePlayback playback(borrow(source), {.video_clock = true});
  source.arrive(ManualClock().now());
  Instant now{};
  EXPECT_TRUE(playback.advance(now));
  now += 40ms;
  EXPECT_FALSE(playback.advance(now));
  EXPECT_EQ(playback.keyframes_played(), 1U) << "after its own time";
  EXPECT_EQ(playback.delays().all().keyframes, 0U);
}

}  // namespace
}  // namespace aucast::playback
