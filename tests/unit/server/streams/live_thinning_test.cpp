#include "server/streams/live_thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "server/streams/thinning.h"
#include "tests/support/seeded.h"
#include "tests/support/steady_time.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using protocol::Keyframe;

/// A keyframe of twelve AUs of which each changes from `n` to `n` + 1.
Keyframe busy(int n, std::optional<std::uint32_t> time_ms) {
  Keyframe keyframe;
  for (int au = 1; au <= 12; ++au) {
    keyframe.terms.push_back(
        {static_cast<std::uint8_t>(au), Side::Both, static_cast<std::uint8_t>(10 + (n + au) % 90)});
  }
  keyframe.time_ms = time_ms;
  return keyframe;
}

TEST(LiveThinning, LetsThroughAtOnceWhatFits) {
  for (const std::uint32_t kbits : {0U, 1000U}) {
    LiveThinning thinning(250, {kbits, 0ms});
    for (int i = 0; i < 100; ++i) {
      thinning.push(busy(i, 40));
      EXPECT_EQ(thinning.pop(test::at_second(i * 0.04)), busy(i, 40));
      EXPECT_FALSE(thinning.due());
    }
  }
}

TEST(LiveThinning, TheNewestTakesPlaceAndTimeOfTheOneThatWaits) {
  LiveThinning thinning(250, {8, 0ms});
  for (int i = 0; i < 100; ++i) {
    thinning.push(busy(0, 40));
    if (!thinning.pop(test::at_second(0))) break;
  }
  (void)thinning.take_last();
  thinning.push(busy(1, std::nullopt));
  thinning.push(busy(2, 30));
  ASSERT_TRUE(thinning.due());
  const SteadyTime due = *thinning.due();
  EXPECT_GT(due, test::at_second(0));
  EXPECT_EQ(thinning.pop(due - 1ms), std::nullopt);
  EXPECT_EQ(thinning.pop(due), busy(2, 250 + 30));
  EXPECT_EQ(thinning.take_last(), std::nullopt);
}

TEST(LiveThinning, TheFaceGoesWithoutWhatTheVoiceTakes) {
  const auto keyframes_beside = [](std::size_t voice_bytes) {
    LiveThinning thinning(40, {24, 180ms, 14, 60ms});
    int sent = 0;
    for (int ms = 0; ms < 10'000; ms += 20) {
      if (ms % 60 == 0 && voice_bytes > 0)
        thinning.spend(voice_bytes, SteadyTime(Milliseconds(ms)));
      if (ms % 40 == 0) thinning.push(busy(ms / 40, 40));
      sent += thinning.pop(SteadyTime(Milliseconds(ms))) ? 1 : 0;
    }
    return sent;
  };
  EXPECT_GT(keyframes_beside(0), 200);
  EXPECT_GT(keyframes_beside(0), keyframes_beside(60) + 50);
  EXPECT_GT(keyframes_beside(60), keyframes_beside(110) + 20);
  EXPECT_GT(keyframes_beside(110), 10) << "some is left for the face";
  EXPECT_LE(keyframes_beside(400), 2) << "the voice comes first";
}

/// Keyframes and voice as they like, written alone or in batches: nothing of the face is lost but
/// what was merged, and no second of what is written holds more than the limit.
TEST(LiveThinning, NoSecondHoldsMoreThanTheLimit) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 40; ++run) {
    const int batch_ms = seeded.integer(0, 1) * 180;
    // 16.7 voice packets a second: in batches 10 to 15 kbit/s with their headers, alone 20.
    const auto kbits = static_cast<std::uint32_t>(seeded.integer(26, 60));
    LiveThinning thinning(250, {kbits, Milliseconds(batch_ms), 14, 60ms});
    std::vector<std::pair<int, double>> written;  // when in ms, bits
    int flush_at = -1;                            // -1: nothing is gathered
    const auto write = [&](double bytes, int ms) {
      if (batch_ms == 0) {
        written.emplace_back(ms, (bytes + kHeaderBytes) * 8);
        return;
      }
      if (flush_at < 0) {
        flush_at = ms + batch_ms;
        written.emplace_back(flush_at, kHeaderBytes * 8.0);
      }
      written.back().second += bytes * 8;
    };
    std::uint64_t given_ms = 0;
    std::uint64_t sent_ms = 0;
    protocol::KeyframeEncoder encoder(250, 0);
    for (int ms = 0; ms < 20'000; ++ms) {
      const SteadyTime now(Milliseconds{ms});
      if (flush_at >= 0 && ms >= flush_at) flush_at = -1;
      if (ms % 60 == 0 && ms / 4000 % 2 == 0) {
        const auto bytes = static_cast<std::size_t>(seeded.integer(60, 100));
        thinning.spend(bytes, now);
        write(static_cast<double>(bytes), ms);
      }
      if (ms % 40 == 0) {
        thinning.push(busy(seeded.integer(0, 80), 40));
        given_ms += 40;
      }
      auto keyframe = thinning.pop(now);
      if (ms + 1 == 20'000 && !keyframe) {
        keyframe = thinning.take_last();
        if (keyframe) sent_ms += *keyframe->time_ms;
        continue;
      }
      if (!keyframe) continue;
      sent_ms += *keyframe->time_ms;
      write(static_cast<double>(encoder.next(*keyframe).changes.size()), ms);
    }
    EXPECT_EQ(sent_ms, given_ms);
    for (std::size_t from = 0; from < written.size(); ++from) {
      double bits = 0;
      for (std::size_t to = from;
           to < written.size() && written[to].first < written[from].first + 1000; ++to) {
        bits += written[to].second;
      }
      ASSERT_LE(bits, kbits * 1000.0)
          << "from " << written[from].first << " ms, batch " << batch_ms;
    }
  }
}

}  // namespace
}  // namespace aucast::server
