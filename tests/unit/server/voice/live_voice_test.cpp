// Sound that comes while a live face does: bytes and times in, packets with places out.
#include "server/voice/live_voice.h"

#include <gtest/gtest.h>

#include "server/voice/slow_line.h"
#include "tests/support/steady_time.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using test::at_second;
using Packets = std::vector<protocol::VoicePacket>;

constexpr Milliseconds kChunk{100};

std::string raw(const std::vector<float>& samples) {
  std::string bytes;
  for (const float sample : samples) {
    const auto value = static_cast<int>(sample * 32767);
    bytes += static_cast<char>(value & 0xFF);
    bytes += static_cast<char>(value >> 8);
  }
  return bytes;
}

/// A microphone whose sound arrives in chunks, and a face that makes 25 keyframes a second.
class LiveVoiceTest : public ::testing::Test {
 protected:
  void face_until(SteadyTime now) {
    for (; face_begin_ + face_end_ <= now; face_end_ += 40ms) {
      voice_.add_keyframe(face_end_, face_begin_ + face_end_);
    }
  }
  /// The next chunk, which arrives `late` after its last sample was heard.
  Packets speak(Milliseconds late = 0ms) {
    now_ += kChunk;
    face_until(now_);
    const std::size_t count = kChunk.count() * voice::kEncoderSamplesPerMs * 2;
    if (at_ + count > sound_.size()) at_ = 0;
    Packets packets = voice_.add(std::string_view(sound_).substr(at_, count), now_ + late);
    at_ += count;
    for (const protocol::VoicePacket& packet : packets) {
      EXPECT_TRUE(all_.empty() || packet.place >= all_.back().place + 60ms);
      all_.push_back(packet);
    }
    return packets;
  }
  /// Of the sound that was heard last, where its last packet ends, less where it should.
  [[nodiscard]] Milliseconds off() const {
    const auto should = std::chrono::duration_cast<Milliseconds>(now_ - face_begin_);
    return all_.back().place + 60ms - should;
  }

  LiveVoice voice_{{}, 0ms};
  std::string sound_ = raw(voice::test::speech_like(20));
  std::size_t at_ = 0;
  Instant now_{10s};
  const Instant face_begin_{10'500ms};
  Milliseconds face_end_{0};
  Packets all_;
};

TEST_F(LiveVoiceTest, HasNoPlaceBeforeTheFace) {
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(speak().empty());
  for (int i = 0; i < 6; ++i) static_cast<void>(speak());
  ASSERT_FALSE(all_.empty());
  EXPECT_LT(all_.front().place, 200ms);
}

TEST_F(LiveVoiceTest, IsPlacedWhereTheFaceWasThen) {
  for (int i = 0; i < 50; ++i) static_cast<void>(speak());
  EXPECT_NEAR(static_cast<double>(off().count()), 0, 60) << "of a packet that is not full yet";
}

TEST_F(LiveVoiceTest, AJitterOfThePipeMovesNothing) {
  for (int i = 0; i < 20; ++i) static_cast<void>(speak());
  const std::size_t before = all_.size();
  for (int i = 0; i < 60; ++i) static_cast<void>(speak(i % 3 == 0 ? 200ms : 50ms));
  for (std::size_t i = before + 1; i < all_.size(); ++i) {
    EXPECT_EQ(all_[i].place - all_[i - 1].place, 60ms) << "no gap";
  }
}

TEST_F(LiveVoiceTest, SoundThatWasLostLeavesAGap) {
  for (int i = 0; i < 20; ++i) static_cast<void>(speak());
  now_ += 5s;
  for (int i = 0; i < 60; ++i) static_cast<void>(speak());
  EXPECT_NEAR(static_cast<double>(off().count()), 0, 60);
}

TEST_F(LiveVoiceTest, AnOddByteIsHalfASample) {
  LiveVoice whole({}, 0ms);
  LiveVoice cut({}, 0ms);
  whole.add_keyframe(0ms, at_second(0));
  cut.add_keyframe(0ms, at_second(0));
  const std::string bytes = sound_.substr(0, 32000);
  const Packets expected = whole.add(bytes, at_second(1));
  EXPECT_FALSE(expected.empty());
  Packets packets = cut.add(bytes.substr(0, 9999), at_second(9999.0 / 32000));
  for (auto& packet : cut.add(bytes.substr(9999), at_second(1))) packets.push_back(packet);
  EXPECT_EQ(packets, expected);
}

TEST_F(LiveVoiceTest, WhatIsNoWholePacketAtTheEndIsHeardToo) {
  LiveVoice voice({}, 0ms);
  voice.add_keyframe(0ms, at_second(0));
  Packets packets = voice.add(sound_.substr(0, 32'000), at_second(1));
  for (auto& packet : voice.end_sound()) packets.push_back(std::move(packet));
  EXPECT_EQ(packets.size(), 17U) << "a second is 16 packets and two thirds of one";
  EXPECT_TRUE(voice.end_sound().empty());
}

TEST(LiveVoiceDelay, APositiveOneMakesTheSoundLater) {
  const std::string bytes = raw(voice::test::speech_like(1));
  const auto first_place = [&bytes](Milliseconds delay) {
    LiveVoice voice({}, delay);
    voice.add_keyframe(5s, at_second(10));
    return voice.add(bytes, at_second(11)).at(0).place;
  };
  EXPECT_EQ(first_place(0ms), 5s);
  EXPECT_EQ(first_place(300ms), 5300ms);
  EXPECT_EQ(first_place(-300ms), 4700ms);
}

double begin_of(const SlowLine& line) {
  return seconds(line.begin().time_since_epoch());
}

TEST(SlowLine, BelievesTheEarliest) {
  SlowLine line;
  EXPECT_FALSE(line.known());
  line.add(at_second(10.5), Seconds(0.1));
  EXPECT_DOUBLE_EQ(begin_of(line), 10.4);
  line.add(at_second(10.6), Seconds(0.6));
  EXPECT_DOUBLE_EQ(begin_of(line), 10.0) << "more had been made than had come";
  line.add(at_second(11.2), Seconds(1.0));
  EXPECT_NEAR(begin_of(line), 10.0, 0.001) << "it waited somewhere";
}

TEST(SlowLine, FollowsAClockThatDrifts) {
  SlowLine line;
  for (int i = 0; i < 36000; ++i) line.add(at_second(i * 0.1), Seconds(i * 0.1 * (1 - 100e-6)));
  EXPECT_NEAR(begin_of(line), 0.36, 0.01);
}

TEST(SlowLine, WhatIsLateForLongWasLost) {
  SlowLine line;
  for (int i = 0; i < 10; ++i) line.add(at_second(i), Seconds(i));
  for (int i = 10; i < 20; ++i) line.add(at_second(i + 1), Seconds(i));
  EXPECT_NEAR(begin_of(line), 1, 0.01);
}

}  // namespace
}  // namespace aucast::server
