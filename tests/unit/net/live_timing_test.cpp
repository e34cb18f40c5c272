#include "client/net/live_timing.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>

#include "tests/support/manual_clock.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using playback::BufferOptions;

class Timing : public ::testing::Test {
 protected:
  static BufferOptions adapting(Milliseconds delay = 300ms) {
    BufferOptions options;
    options.live_delay = delay;
    options.adapt = true;
    return options;
  }

  /// A keyframe without a time of its own has come `after` the last one; it takes 40 ms.
  std::optional<Milliseconds> arrived(LiveTiming& timing, Duration after = 40ms) {
    clock_.advance(after);
    last_ = {};
    last_.arrived = clock_.now();
    return timing.arrived(last_, 40ms, std::nullopt);
  }
  /// Regularly, until the jitter is known.
  std::optional<Milliseconds> settle(LiveTiming& timing) {
    std::optional<Milliseconds> held;
    for (Duration passed{0}; passed <= playback::JitterMeter::kWindow; passed += 40ms) {
      held = arrived(timing);
    }
    return held;
  }

  ManualClock clock_;
  playback::Keyframe last_;
};

TEST_F(Timing, TheFirstDelayCoversAPacketThatIsSentAgain) {
  LiveTiming timing(adapting(100ms));
  timing.connected(20ms);
  EXPECT_EQ(timing.first_delay(), 100ms) << "what was asked for is more";
  timing.connected(200ms);
  EXPECT_EQ(timing.first_delay(), 500ms);
  timing.connected(10s);
  EXPECT_EQ(timing.first_delay(), 4s) << "no more than that";
  LiveTiming patient(adapting(20s));
  patient.connected(10s);
  EXPECT_EQ(patient.first_delay(), 20s) << "but what was asked for";
}

TEST_F(Timing, WithoutAdaptingNothingIsMeasured) {
  auto options = adapting();
  options.adapt = false;
  LiveTiming timing(options);
  timing.connected(0ms);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(arrived(timing, 500ms), std::nullopt);
    EXPECT_EQ(last_.due, std::nullopt);
  }
}

TEST_F(Timing, BeforeTheJitterIsKnownNoLessIsHeldThanAtFirst) {
  LiveTiming timing(adapting());
  timing.connected(0ms);
  EXPECT_EQ(arrived(timing), std::nullopt) << "who joins is sent one that has begun";
  EXPECT_EQ(arrived(timing), 300ms);
  EXPECT_EQ(arrived(timing, 540ms), 560ms) << "half a second late, and the margin";
}

TEST_F(Timing, OnceItIsKnownItAloneCounts) {
  LiveTiming timing(adapting());
  timing.connected(0ms);
  EXPECT_EQ(settle(timing), 60ms) << "the margin is left";
  EXPECT_EQ(arrived(timing, 140ms), 160ms);
  EXPECT_EQ(arrived(timing, 20s), 4s) << "no more than that";
}

TEST_F(Timing, AfterAPauseTheFirstKeyframeTellsNothing) {
  LiveTiming timing(adapting());
  timing.connected(0ms);
  EXPECT_EQ(settle(timing), 60ms);
  timing.begin_again();
  EXPECT_EQ(arrived(timing, 10s), std::nullopt);
  EXPECT_EQ(arrived(timing), 300ms) << "it is measured anew";
}

TEST_F(Timing, WithLowDelayEachKeyframeSaysWhenItIsDue) {
  auto options = adapting();
  options.low_delay = true;
  LiveTiming timing(options);
  timing.connected(0ms);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(arrived(timing), std::nullopt);
    ASSERT_TRUE(last_.due.has_value());
    EXPECT_EQ(*last_.due - clock_.now(), 42ms) << "its own time, and what computers add";
  }
  EXPECT_EQ(timing.low_delay(), 42ms);
}

}  // namespace
}  // namespace aucast::net
