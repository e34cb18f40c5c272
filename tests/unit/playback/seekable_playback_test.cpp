#include "client/playback/seekable_playback.h"

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"

namespace aucast::playback {
namespace {

/// Two keyframes: one of 100 ms, one without a time of its own, which takes 250.
class SeekablePlaybackTest : public ::testing::Test {
 protected:
  std::optional<KeyframeBegun> after(int ms) {
    clock_.advance(Milliseconds(ms));
    return playback_.advance(clock_.now());
  }

  static std::vector<Keyframe> two() {
    const AuTerm term{12};
    return {{frame_from_terms({&term, 1}), Milliseconds(100)}, {AuFrame{}, std::nullopt}};
  }

  aucast::test::ManualClock clock_;
  SeekablePlayback playback_{two(), Milliseconds(250)};
};

TEST_F(SeekablePlaybackTest, PlaysFromTheFirstLookOn) {
  EXPECT_EQ(playback_.progress().keyframe, 0U);
  EXPECT_EQ(playback_.status().keyframes_received, 2U);
  const auto first = after(5000);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->from, AuFrame{});
  EXPECT_EQ(first->time, Milliseconds(100));
  EXPECT_FALSE(after(0)) << "it has begun";
  EXPECT_EQ(playback_.state(), PlaybackState::Playing);
  EXPECT_FALSE(after(50));
  EXPECT_EQ(playback_.progress().keyframe, 1U);
  EXPECT_DOUBLE_EQ(playback_.progress().mu, 0.5);
  EXPECT_TRUE(playback_.next_position_at());
}

TEST_F(SeekablePlaybackTest, AKeyframeSetsOutFromTheOneBefore) {
  static_cast<void>(after(0));
  const auto second = after(200);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->from, two()[0].aus);
  EXPECT_EQ(second->time, Milliseconds(250));
  EXPECT_EQ(playback_.keyframes_played(), 1U);
  EXPECT_EQ(playback_.media_time(), Milliseconds(100));
}

TEST_F(SeekablePlaybackTest, PausesAndBeginsAnewAtTheEnd) {
  static_cast<void>(after(0));
  playback_.pause(clock_.now());
  static_cast<void>(after(1000));
  EXPECT_EQ(playback_.state(), PlaybackState::Paused);
  EXPECT_EQ(playback_.position(), Duration::zero());
  EXPECT_FALSE(playback_.next_position_at());
  playback_.resume(clock_.now());
  static_cast<void>(after(1000));
  EXPECT_EQ(playback_.state(), PlaybackState::Ended);
  EXPECT_TRUE(playback_.over());
  EXPECT_EQ(playback_.status().end, EndReason::EndOfStream);
  playback_.resume(clock_.now());
  static_cast<void>(after(10));
  EXPECT_EQ(playback_.position(), Milliseconds(10));
  EXPECT_FALSE(playback_.over());
}

TEST_F(SeekablePlaybackTest, StoppedBeforeTheEndSaysSo) {
  static_cast<void>(after(0));
  static_cast<void>(after(50));
  playback_.stop(clock_.now());
  EXPECT_EQ(playback_.state(), PlaybackState::Stopped);
  EXPECT_EQ(playback_.status().end, EndReason::Stopped);
  EXPECT_TRUE(playback_.over());
}

TEST_F(SeekablePlaybackTest, StoppedAtTheEndItHasEnded) {
  static_cast<void>(after(0));
  static_cast<void>(after(350));
  playback_.stop(clock_.now());
  EXPECT_EQ(playback_.state(), PlaybackState::Ended);
  EXPECT_EQ(playback_.status().end, EndReason::EndOfStream);
}

TEST_F(SeekablePlaybackTest, WhoSeeksFirstPlaysFromThere) {
  playback_.playhead(clock_.now()).seek(Milliseconds(100), clock_.now());
  static_cast<void>(after(10));
  EXPECT_EQ(playback_.position(), Milliseconds(110));
  EXPECT_EQ(playback_.seekable(), &playback_);
}

}  // namespace
}  // namespace aucast::playback
