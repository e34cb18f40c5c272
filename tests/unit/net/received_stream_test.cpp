#include "client/net/received_stream.h"

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/support/seeded.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using aucast::test::Seeded;

/// A keyframe that can be told from the others by its `mark`.
protocol::DeliverKeyframe marked(int mark, std::optional<std::uint32_t> time_ms = std::nullopt) {
  protocol::DeliverKeyframe event;
  event.aus.left[1] = static_cast<float>(mark);
  event.time_ms = time_ms;
  return event;
}
int mark_of(const playback::Keyframe& keyframe) {
  return static_cast<int>(keyframe.aus.left[1]);
}

class Receiving : public ::testing::Test {
 protected:
  void add(int mark, std::optional<std::uint32_t> time_ms = std::nullopt, bool aside = false) {
    stream_.add(marked(mark, time_ms), clock_.now(), aside);
  }
  /// The mark of the next keyframe, 0 when there is none.
  int take() {
    const auto keyframe = stream_.take();
    place_ = keyframe ? keyframe->place.value_or(-1ms) : -1ms;
    return keyframe ? mark_of(*keyframe) : 0;
  }
  [[nodiscard]] playback::SourceStatus status() const {
    playback::SourceStatus status;
    stream_.describe(status);
    return status;
  }

  ManualClock clock_;
  ReceivedStream stream_{playback::BufferOptions{2, 1, 50}, std::nullopt};
  Milliseconds place_{0};  ///< of the keyframe taken last
};

TEST_F(Receiving, KeepsInOrderWhatTheBuffersHaveNoRoomFor) {
  for (int mark = 1; mark <= 6; ++mark) add(mark);
  EXPECT_EQ(stream_.kept(), 3U);
  for (int mark = 1; mark <= 6; ++mark) {
    EXPECT_EQ(take(), mark);
    EXPECT_EQ(place_, mark * 250ms);
  }
  EXPECT_EQ(stream_.kept(), 0U);
}

TEST_F(Receiving, ForgetsTheKeyframeAsideAndItsTime) {
  add(1, 100, true);
  EXPECT_FALSE(stream_.ready());
  EXPECT_EQ(stream_.kept(), 0U) << "it does not fill the buffers";
  stream_.forget_aside();
  EXPECT_EQ(stream_.place(), 0ms);
  add(2, 100);
  stream_.end();
  EXPECT_EQ(take(), 2);
  EXPECT_EQ(place_, 100ms);
  EXPECT_TRUE(stream_.finished());
}

TEST_F(Receiving, LetsTheKeyframeAsideInBeforeWhateverComesNext) {
  add(1, 100, true);
  add(2, 100);
  stream_.break_off();
  add(3, 100, true);
  stream_.break_off();
  add(4, 100, true);
  stream_.end();
  for (const int mark : {1, 2, 3, 4}) EXPECT_EQ(take(), mark);
  EXPECT_TRUE(stream_.finished());
}

TEST_F(Receiving, GoesByTheHelloOfTheServerThatItHasNow) {
  protocol::HelloGranted hello;
  hello.live = true;
  hello.keyframe_ms = 40;
  hello.title = "Lecture";
  hello.voice = protocol::kVoiceCodec;
  stream_.begin(hello);
  add(1);
  EXPECT_TRUE(status().live);
  EXPECT_TRUE(status().voice);
  EXPECT_EQ(status().title, "Lecture");
  EXPECT_EQ(stream_.place(), 40ms);
  stream_.begin({});
  EXPECT_FALSE(status().live);
  EXPECT_FALSE(status().voice);
  EXPECT_EQ(status().title, "");
  EXPECT_EQ(stream_.place(), 0ms) << "its stream begins here";
}

TEST_F(Receiving, SaysWhenALiveKeyframeCameButNotWhenItIsDueWhileTheUserPauses) {
  playback::BufferOptions options;
  options.low_delay = true;
  ReceivedStream stream(options, std::nullopt);
  protocol::HelloGranted hello;
  hello.live = true;
  stream.begin(hello);
  stream.add(marked(1), clock_.now(), false);
  EXPECT_TRUE(stream.take()->due);
  stream.set_paused(true);
  stream.add(marked(2), clock_.now(), false);
  const auto keyframe = stream.take();
  EXPECT_EQ(keyframe->arrived, clock_.now());
  EXPECT_FALSE(keyframe->due);
}

/// Over any number of connections, each granting what it likes: every keyframe comes out once and
/// in order, each one's place is the sum of the times so far, and spoken places keep their distance
/// to the keyframes of their connection.
TEST_F(Receiving, GivesEachOnceOnOneClockOverAllConnections) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 200; ++round) {
    ReceivedStream stream(playback::BufferOptions{static_cast<std::size_t>(seeded.integer(1, 5)), 1,
                                                  seeded.integer(1, 100)},
                          std::nullopt);
    int added = 0;
    int taken = 0;
    Milliseconds clock{0};
    std::vector<Milliseconds> places;
    const auto take = [&] {
      const auto keyframe = stream.take();
      if (!keyframe) return false;
      EXPECT_EQ(mark_of(*keyframe), ++taken);
      EXPECT_EQ(keyframe->place, places[static_cast<std::size_t>(taken - 1)]);
      return true;
    };
    for (int connection = 0; connection < 5; ++connection) {
      protocol::HelloGranted hello;
      hello.keyframe_ms = static_cast<std::uint32_t>(seeded.integer(1, 500));
      hello.from_ms = static_cast<std::uint64_t>(seeded.integer(0, 10'000));
      stream.begin(hello);
      ASSERT_EQ(stream.place(), Milliseconds(hello.from_ms));
      stream.add(protocol::CaptionData{.place_ms = hello.from_ms + 70, .text = "a"});
      ASSERT_EQ(stream.spoken().take_caption()->place, clock + 70ms);
      if (seeded.chance(0.3)) {
        stream.add(marked(-1), clock_.now(), true);
        stream.forget_aside();
      }
      for (int i = seeded.integer(0, 10); i > 0; --i) {
        std::optional<std::uint32_t> time_ms;
        if (seeded.chance(0.5)) time_ms = static_cast<std::uint32_t>(seeded.integer(0, 300));
        stream.add(marked(++added, time_ms), clock_.now(), seeded.chance(0.2));
        clock += Milliseconds(time_ms.value_or(hello.keyframe_ms));
        places.push_back(clock);
        if (seeded.chance(0.4)) take();
      }
      stream.break_off();
    }
    stream.end();
    while (take()) {
    }
    EXPECT_EQ(taken, added);
    EXPECT_TRUE(stream.finished());
  }
}

}  // namespace
}  // namespace aucast::net
