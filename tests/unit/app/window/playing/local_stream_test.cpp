#include "client/app/window/playing/local_stream.h"

#include <memory>
#include <optional>
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

TEST_F(LocalStreamTest, StopHoldsItAtItsBeginningAndResumePlaysIt) {
  EXPECT_FALSE(stream_.stands());
  go_on(Milliseconds(50));
  stream_.stop(clock_.now());
  EXPECT_TRUE(stream_.stands());
  EXPECT_TRUE(stream_.running());
  go_on(Milliseconds(1'000));
  EXPECT_EQ(stream_.local_view().position, Milliseconds(0));
  EXPECT_TRUE(stream_.resume(clock_.now()));
  go_on(Milliseconds(10));
  EXPECT_EQ(stream_.local_view().position, Milliseconds(10));
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

/// Keyframes of these times.
std::unique_ptr<playback::SeekablePlayback> of_times(const std::vector<int>& times) {
  std::vector<playback::Keyframe> keyframes;
  for (const int ms : times) keyframes.push_back(marked(1, Milliseconds(ms)));
  return std::make_unique<playback::SeekablePlayback>(std::move(keyframes), Milliseconds(300));
}

TEST_F(LocalStreamTest, AFrameIsAPictureOfWhatWasRecorded) {
  LocalStream film(of_times({500, 33, 33, 34, 33, 33, 34}), "camera.csv", std::nullopt, notices_);
  EXPECT_EQ(film.local_view().step_fps, 30);
  film.apply(gui::Seek{Milliseconds(500)}, clock_.now());
  std::vector<Duration> places;
  const auto step = [&](int direction) {
    film.apply(gui::StepFrame{direction}, clock_.now());
    while (film.playback().advance(clock_.now())) {
    }
    places.push_back(film.local_view().position);
  };
  for (const int direction : {1, 1, 1, -1, -1}) step(direction);
  const std::vector<Duration> wanted{Milliseconds(533), Milliseconds(566), Milliseconds(600),
                                     Milliseconds(566), Milliseconds(533)};
  EXPECT_EQ(places, wanted);
}

TEST_F(LocalStreamTest, AFrameOfWrittenFacesIsOneOfTheVideos) {
  for (const std::vector<int>& times :
       {std::vector{300}, std::vector{500, 500, 500, 500, 500}, std::vector{40, 70, 90, 40, 20}}) {
    const LocalStream faces(of_times(times), "faces.txt", std::nullopt, notices_);
    EXPECT_EQ(faces.local_view().step_fps, 25) << times.size();
  }
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

TEST_F(LocalStreamTest, WhatBeginsAnewAfterItsEndIsShown) {
  go_on(Milliseconds(600));
  EXPECT_FALSE(ask(gui::SetSpeed{50})) << "that begins nothing";
  EXPECT_TRUE(ask(gui::ToggleRepeat{}));
  EXPECT_FALSE(stream_.stands());
}

TEST_F(LocalStreamTest, ALoopThatEndsWithItIsShownLikewise) {
  go_on(Milliseconds(200));
  EXPECT_FALSE(ask(gui::MarkLoop{}));
  go_on(Milliseconds(400));
  EXPECT_TRUE(stream_.stands());
  EXPECT_TRUE(ask(gui::MarkLoop{}));
  EXPECT_FALSE(stream_.stands());
  EXPECT_EQ(stream_.local_view().position, Milliseconds(200));
}

TEST_F(LocalStreamTest, AllOfItIsExportedWhereverItStands) {
  EXPECT_EQ(stream_.played().keyframes.size(), 3U);
  EXPECT_EQ(stream_.played().begun, 3U);
  EXPECT_EQ(stream_.played().untimed, Milliseconds(300)) << "as they are played";
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
