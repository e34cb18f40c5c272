#include "client/app/window/playing/local_stream.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/unit/playback/marked.h"

namespace aucast::app {
namespace {

using playback::test::marked;

/// Three keyframes of 100, 200 and 300 ms.
class LocalStreamTest : public testing::Test {
 protected:
  void SetUp() override { go_on(Milliseconds(0)); }
  void go_on(Milliseconds time) {
    clock_.advance(time);
    while (stream_.playback().advance(clock_.now())) {
    }
  }
  bool ask(const gui::LocalCommand& command) {
    const bool shows = stream_.apply(command, clock_.now());
    go_on(Milliseconds(0));
    return shows;
  }

  test::ManualClock clock_;
  Notices notices_;
  LocalStream stream_{
      std::make_unique<playback::SeekablePlayback>(
          std::vector{marked(1, Milliseconds(100)), marked(2, Milliseconds(200)), marked(3)},
          Milliseconds(300)),
      "three.txt", 10, notices_};
};

TEST_F(LocalStreamTest, StopOnlyHoldsItAndResumePlaysOn) {
  EXPECT_FALSE(stream_.stands());
  go_on(Milliseconds(50));
  stream_.stop(clock_.now());
  EXPECT_TRUE(stream_.stands());
  EXPECT_TRUE(stream_.running());
  go_on(Milliseconds(1'000));
  EXPECT_TRUE(stream_.resume(clock_.now()));
  go_on(Milliseconds(10));
  EXPECT_EQ(stream_.local_view().position, Milliseconds(60));
}

TEST_F(LocalStreamTest, AfterItsEndItBeginsAnew) {
  go_on(Milliseconds(600));
  EXPECT_TRUE(stream_.stands());
  EXPECT_FALSE(stream_.running());
  EXPECT_FALSE(stream_.ended_by_server()) << "there is none";
  EXPECT_TRUE(stream_.resume(clock_.now()));
  go_on(Milliseconds(10));
  EXPECT_EQ(stream_.local_view().position, Milliseconds(10));
}

TEST_F(LocalStreamTest, OnlyWhatMovesTheFaceShowsIt) {
  EXPECT_TRUE(ask(gui::Seek{Milliseconds(150)}));
  EXPECT_EQ(stream_.local_view().keyframe, 2U);
  EXPECT_TRUE(ask(gui::SeekBy{Milliseconds(-100)}));
  EXPECT_EQ(stream_.local_view().position, Milliseconds(50));
  EXPECT_TRUE(ask(gui::StepKeyframe{1}));
  EXPECT_EQ(stream_.local_view().position, Milliseconds(100));
  EXPECT_TRUE(ask(gui::StepFrame{1})) << "a tenth of a second, as told";
  EXPECT_EQ(stream_.local_view().position, Milliseconds(200));
  EXPECT_FALSE(ask(gui::SetSpeed{50}));
  EXPECT_FALSE(ask(gui::ChangeSpeed{1}));
  EXPECT_EQ(stream_.local_view().speed_percent, 75);
  EXPECT_FALSE(ask(gui::MarkLoop{}));
  EXPECT_EQ(stream_.local_view().loop_begin, Milliseconds(200));
}

TEST_F(LocalStreamTest, WhetherItRepeatsIsSaid) {
  EXPECT_FALSE(ask(gui::ToggleRepeat{}));
  EXPECT_TRUE(stream_.local_view().repeats);
  const std::string repeats = notices_.view().text;
  EXPECT_FALSE(repeats.empty());
  ask(gui::ToggleRepeat{});
  EXPECT_FALSE(stream_.local_view().repeats);
  EXPECT_NE(notices_.view().text, repeats);
}

TEST_F(LocalStreamTest, AllOfItIsExportedWhereverItStands) {
  EXPECT_EQ(stream_.played().keyframes.size(), 3U);
  EXPECT_EQ(stream_.played().begun, 3U);
  EXPECT_EQ(stream_.title("AUcast", false), "three.txt - AUcast");
}

TEST_F(LocalStreamTest, HasNoBuffersToShow) {
  gui::PlayingView view;
  stream_.describe(view);
  EXPECT_TRUE(view.local);
  EXPECT_EQ(view.keyframe, "keyframe 1 of 3");
  EXPECT_TRUE(view.receiver_history.empty());
}

}  // namespace
}  // namespace aucast::app
