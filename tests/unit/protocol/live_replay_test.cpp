#include "protocol/live_replay.h"

#include <gtest/gtest.h>

#include "tests/unit/protocol/packets.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;

const Instant kReplayBegin = Instant{} + 1h;

std::shared_ptr<const EncodedStream> stream_of(std::vector<KeyframeTime> times,
                                               PacketList changes = {}) {
  EncodedStream stream;
  for (std::size_t i = 0; i < times.size(); ++i) {
    stream.classic.push_back("{" + std::to_string(i) + "}");
    stream.negotiated.push_back("{" + std::to_string(i) + ":50}");
  }
  stream.changes = std::move(changes);
  stream.times = std::move(times);
  stream.duration_ms = 300;
  return std::make_shared<const EncodedStream>(std::move(stream));
}

std::vector<KeyframeTime> times(std::size_t count, std::uint32_t ms) {
  return std::vector<KeyframeTime>(count, KeyframeTime(ms));
}

TEST(LiveReplay, ShowsEachMomentInEveryFormWhenItsTimeComes) {
  LiveReplay replay(stream_of(times(3, 100), test::packets({"{0:50}", "{~1}", "{~2}"})), false,
                    kReplayBegin);
  EXPECT_EQ(replay.newest(), nullptr);
  EXPECT_TRUE(replay.advance(kReplayBegin));
  ASSERT_NE(replay.newest(), nullptr);
  EXPECT_FALSE(replay.advance(kReplayBegin + 99ms));
  EXPECT_TRUE(replay.advance(kReplayBegin + 100ms));
  EXPECT_EQ(replay.newest()->number, 1U);
  EXPECT_EQ(replay.newest()->classic, "{1}");
  EXPECT_EQ(replay.newest()->full, "{1:50}");
  EXPECT_EQ(replay.newest()->changes, "{~1}");
  EXPECT_EQ(replay.duration_ms(), 300U);
  EXPECT_TRUE(replay.has_changes());
}

TEST(LiveReplay, ShowsAllThatBeganAtOnce) {
  LiveReplay replay(stream_of(times(3, 100)), false, kReplayBegin);
  EXPECT_TRUE(replay.advance(kReplayBegin + 250ms));
  ASSERT_EQ(replay.latest().size(), 3U);
  EXPECT_EQ(replay.latest()[0].number, 0U);
  EXPECT_EQ(replay.latest()[2].full, "{2:50}");
  EXPECT_FALSE(replay.has_changes());
}

TEST(LiveReplay, EndsWithItsLastMomentHoweverLateItIsAsked) {
  LiveReplay replay(stream_of(times(3, 100)), false, kReplayBegin);
  EXPECT_TRUE(replay.advance(kReplayBegin));
  EXPECT_TRUE(replay.advance(kReplayBegin + 1h));
  EXPECT_TRUE(replay.ended());
  EXPECT_EQ(replay.newest()->number, 2U);
  EXPECT_EQ(replay.newest()->full, "{2:50}");
  EXPECT_FALSE(replay.advance(kReplayBegin + 2h));
  EXPECT_FALSE(replay.next_at().has_value());
}

TEST(LiveReplay, ALoopGoesOnCountingAndHasNoLength) {
  LiveReplay replay(stream_of(times(2, 100)), true, kReplayBegin);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(replay.advance(kReplayBegin + i * 100ms));
  EXPECT_EQ(replay.newest()->number, 2U);
  EXPECT_EQ(replay.newest()->full, "{0:50}");
  EXPECT_FALSE(replay.duration_ms().has_value());
}

TEST(LiveReplay, InALoopEachTurnsVoiceBeginsAtItsBeginning) {
  auto voice = std::make_shared<EncodedTrack>();
  for (const int place : {0, 60, 180}) voice->add({Milliseconds(place), "\x58\x01"});
  voice->finish();
  LiveReplay replay(stream_of(times(2, 100)), true, kReplayBegin,
                    std::make_shared<const SpokenTrack>(SpokenTrack{voice, {}}));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(replay.advance(kReplayBegin + i * 100ms));
  std::vector<Milliseconds> places;
  for (std::uint64_t i = replay.voice().first_number(); replay.voice().find(i) != nullptr; ++i) {
    places.push_back(replay.voice().find(i)->begin);
  }
  EXPECT_EQ(places, (std::vector<Milliseconds>{0ms, 60ms, 200ms, 260ms}));
}

TEST(LiveReplay, InALoopCaptionsComeInEachTurnWithTheKeyframeInWhichTheyAreDue) {
  const std::vector<CaptionData> captions = {
      {0, "one"}, {150, "two"}, {200, "never: the turn is over"}};
  LiveReplay replay(stream_of(times(2, 100)), true, kReplayBegin,
                    std::make_shared<const SpokenTrack>(SpokenTrack{nullptr, captions}));
  std::vector<CaptionData> told;
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(replay.advance(kReplayBegin + i * 100ms));
    while (const CaptionData* const caption = replay.captions().find(told.size())) {
      told.push_back(*caption);
    }
    EXPECT_EQ(told.size(), static_cast<std::size_t>(i) + 1);
  }
  EXPECT_EQ(told, (std::vector<CaptionData>{{0, "one"}, {150, "two"}, {200, "one"}, {350, "two"}}));
}

TEST(SpokenTrack, IsTheSameWhereVoiceAndCaptionsAre) {
  const auto track = [](std::shared_ptr<const EncodedTrack> voice,
                        std::vector<CaptionData> captions) {
    return std::make_shared<const SpokenTrack>(SpokenTrack{std::move(voice), std::move(captions)});
  };
  const auto voice = std::make_shared<const EncodedTrack>();
  EXPECT_TRUE(same_spoken(nullptr, nullptr));
  EXPECT_FALSE(same_spoken(track(voice, {}), nullptr));
  EXPECT_FALSE(same_spoken(nullptr, track(voice, {})));
  EXPECT_TRUE(same_spoken(track(voice, {{0, "one"}}), track(voice, {{0, "one"}})));
  EXPECT_FALSE(same_spoken(track(voice, {{0, "one"}}), track(voice, {{0, "two"}})));
  EXPECT_FALSE(same_spoken(track(voice, {}), track(std::make_shared<const EncodedTrack>(), {})));
}

TEST(LiveReplay, AWindowIsNeverWorthMoreThanTwoSecondsButTwoMoments) {
  const auto window = [](std::vector<KeyframeTime> of) {
    return LiveReplay(stream_of(std::move(of)), false, kReplayBegin).window_max();
  };
  EXPECT_EQ(window(times(1, 250)), 8U);
  EXPECT_EQ(window(times(1, 999)), 2U) << "three would be 2,997 ms";
  EXPECT_EQ(window({KeyframeTime(100), KeyframeTime(200)}), 13U) << "by their mean";
  EXPECT_EQ(window(times(1, 3'600'000)), 2U);
  EXPECT_EQ(window(times(1, 0)), 2000U);
}

}  // namespace
}  // namespace aucast::protocol
