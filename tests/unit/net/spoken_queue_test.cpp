#include "client/net/spoken_queue.h"

#include <string>

#include <gtest/gtest.h>

namespace aucast::net {
namespace {

using namespace std::chrono_literals;

const std::string kTenMs(1, '\0');  ///< an Opus packet

TEST(SpokenQueue, GivesWhatCameInItsOrder) {
  SpokenQueue queue;
  queue.add(playback::Voice{0ms, kTenMs});
  queue.add(playback::Voice{10ms, kTenMs});
  EXPECT_EQ(queue.voice_end(), 20ms);
  EXPECT_EQ(queue.take_voice()->place, 0ms);
  EXPECT_EQ(queue.take_voice()->place, 10ms);
  EXPECT_FALSE(queue.take_voice());
}

TEST(SpokenQueue, VoiceOfOneByteAPacketHasItsLimitToo) {
  SpokenQueue queue;
  for (std::size_t i = 0; i < playback::kVoicePacketsMax; ++i) {
    queue.add(playback::Voice{Milliseconds(10 * static_cast<int>(i)), kTenMs});
  }
  EXPECT_EQ(queue.voice_left_out(), 0U);
  EXPECT_EQ(queue.voice_end(), 1h);
  queue.add(playback::Voice{1h, kTenMs});
  EXPECT_EQ(queue.voice_left_out(), 1U);
  EXPECT_EQ(queue.voice_end(), 1h) << "it was not kept";
  EXPECT_TRUE(queue.take_voice());
  queue.add(playback::Voice{1h, kTenMs});
  EXPECT_EQ(queue.voice_left_out(), 1U) << "what was taken made room";
}

TEST(SpokenQueue, VoiceOfManyBytesIsLimitedByThem) {
  SpokenQueue queue;
  const std::string large(1000, '\0');
  constexpr std::size_t kFit = playback::kVoiceBytesMax / 1000;
  for (std::size_t i = 0; i < kFit + 5; ++i) queue.add(playback::Voice{0ms, large});
  EXPECT_EQ(queue.voice_left_out(), 5U);
}

TEST(SpokenQueue, CaptionsHaveALimitOfTheirOwn) {
  SpokenQueue queue;
  for (std::size_t i = 0; i < SpokenQueue::kCaptionsMax + 3; ++i) {
    queue.add(playback::Caption{0ms, ""});
  }
  EXPECT_EQ(queue.captions_left_out(), 3U);
  EXPECT_EQ(queue.voice_left_out(), 0U);
}

}  // namespace
}  // namespace aucast::net
