// An hour of a live lecture whose player's device has a clock of its own.

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <memory>

#include "client/playback/keyframe_buffers.h"
#include "client/playback/source_playback.h"
#include "client/sound/sound_player.h"

namespace aucast::sound {
namespace {

using namespace std::chrono_literals;
using playback::Keyframe;
using playback::KeyframeBuffers;

constexpr Milliseconds kDriftTick{10};
constexpr Milliseconds kKeyframe{40};
/// Sample i of the track is i modulo this.
constexpr std::int64_t kRound = std::int64_t{10} * kRate;

/// What a network's source is to playback, without the network.
class BufferedSource final : public playback::KeyframeSource {
 public:
  explicit BufferedSource(KeyframeBuffers& buffers) : buffers_(buffers) {}

  [[nodiscard]] std::optional<Keyframe> take() override { return buffers_.take(); }
  [[nodiscard]] bool ready() const override { return buffers_.has_next(); }
  bool wait_until(Instant /*until*/) override { return ready(); }
  [[nodiscard]] playback::SourceStatus status() const override {
    playback::SourceStatus status;
    status.live = true;
    return status;
  }
  void stop() override {}

 private:
  KeyframeBuffers& buffers_;
};

class RoundTrack final : public SoundTrack {
 public:
  void read(std::int64_t begin, std::span<float> samples) override {
    for (float& sample : samples) {
      sample = static_cast<float>(begin < 0 ? 0 : begin % kRound) / kRound;
      ++begin;
    }
  }
  [[nodiscard]] std::int64_t end() const override { return std::int64_t{1} << 40U; }
};

/// What has been heard is forgotten, or an hour would fill the memory.
struct Device {
  std::deque<float> waiting;
  std::int64_t heard = 0;
  double part = 0;  ///< of a sample
  float last = 0;

  void turn(double samples) {
    for (part += samples; part >= 1 && !waiting.empty(); --part) {
      last = waiting.front();
      waiting.pop_front();
      ++heard;
    }
  }
};

class DeviceOut final : public SoundOut {
 public:
  explicit DeviceOut(Device& device) : device_(device) {}
  void write(std::span<const float> samples) override {
    device_.waiting.insert(device_.waiting.end(), samples.begin(), samples.end());
  }
  [[nodiscard]] std::int64_t heard() override { return device_.heard; }
  [[nodiscard]] bool lost() override { return false; }

 private:
  Device& device_;
};

class SoundDrift : public testing::TestWithParam<int> {};

TEST_P(SoundDrift, OfAnHourIsTakenOutOfPausesAndTheFaceStaysWithTheSound) {
  const double rate = 1 + GetParam() * 1e-6;
  KeyframeBuffers buffers({100, 100, 1, 300ms, false, true, false});
  buffers.set_live(true);
  buffers.set_untimed(kKeyframe);
  playback::SourcePlayback playback(std::make_unique<BufferedSource>(buffers), {});
  RoundTrack track;
  Device device;
  SoundPlayer player(std::make_unique<DeviceOut>(device));
  player.open(&playback, &track);
  Instant steady{1h};
  Milliseconds place{0};
  std::uint64_t stalls_at_first = 0;
  double least = 0;
  double most = 0;
  Milliseconds buffered_least{1h};
  Milliseconds buffered_most{0};
  for (int tick = 0; tick < 3600 * 100; ++tick) {
    steady += kDriftTick;
    if (tick % (kKeyframe / kDriftTick) == 0) {
      Keyframe keyframe;
      keyframe.time = kKeyframe;
      keyframe.span = kKeyframe;
      keyframe.place = place += kKeyframe;
      keyframe.arrived = steady;
      // A pause of a second after nine seconds of speech.
      keyframe.spoken = place % 10s < 9s;
      ASSERT_EQ(buffers.store(keyframe), KeyframeBuffers::Stored::Yes);
    }
    device.turn(seconds(kDriftTick) * kRate * rate);
    const Instant now = player.now(steady);
    while (playback.advance(now)) {
    }
    player.advanced();
    if (tick < 1000) {
      stalls_at_first = playback.stalls();
      continue;
    }
    buffered_least = std::min(buffered_least, buffers.buffered());
    buffered_most = std::max(buffered_most, buffers.buffered());
    const auto passing = playback.passing();
    const double shown = seconds(passing->place) - seconds(now - player.shown()) * passing->speed;
    const double heard = static_cast<double>(device.last) * 10;
    const double early = std::remainder(shown - heard, 10.0);
    // Where the track begins anew, what is resampled lies between.
    if (heard < 0.1 || heard > 9.9) continue;
    least = std::min(least, early);
    most = std::max(most, early);
  }
  EXPECT_EQ(playback.stalls(), stalls_at_first);
  EXPECT_EQ(buffers.dropped(), 0U);
  EXPECT_EQ(player.counts().underruns, 0U);
  EXPECT_GT(least, -0.015);
  EXPECT_LT(most, 0.045);
  EXPECT_GT(buffered_least, 100ms) << "360 ms were to be made good";
  EXPECT_LT(buffered_most, 600ms);
}

INSTANTIATE_TEST_SUITE_P(PartsOfAMillion, SoundDrift, testing::Values(-100, 100));

}  // namespace
}  // namespace aucast::sound
