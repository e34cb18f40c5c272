#include "client/app/window/playing/playback_session.h"

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "client/playback/source_playback.h"
#include "tests/support/kept_log.h"
#include "tests/support/manual_clock.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::app {
namespace {

using gui::Activity;
using playback::test::marked;

/// On a face without any channel.
class PlaybackSessionTest : public testing::Test {
 protected:
  void go_on(Milliseconds time) {
    clock_.advance(time);
    session_.advance(clock_.now());
  }
  bool ask(const gui::PlaybackCommand& command) { return session_.apply(command, clock_.now()); }
  /// A server's stream; the source is the test's to fill.
  playback::test::ScriptedSource& open_remote() {
    auto source = std::make_unique<playback::test::ScriptedSource>();
    playback::test::ScriptedSource& handed = *source;
    handed.now.connected = true;
    session_.open(std::make_unique<playback::SourcePlayback>(std::move(source),
                                                             playback::SourcePlayback::Options{}),
                  {}, clock_.now());
    return handed;
  }
  void open_local() {
    session_.open({marked(1, Milliseconds(100)), marked(2)}, "two.txt", clock_.now());
  }

  test::ManualClock clock_;
  PlayerOptions options_;
  PlayerStats stats_;
  Notices notices_;
  face::Face face_;
  pipeline::AuMapping mapping_{face_, {}, {}};
  std::vector<float> shown_;
  PlaybackSession session_{mapping_, options_, stats_, notices_, shown_};
};

TEST_F(PlaybackSessionTest, WithNothingOpenEveryCommandIsIdle) {
  EXPECT_FALSE(ask(gui::Pause{}));
  EXPECT_FALSE(ask(gui::Resume{}));
  EXPECT_FALSE(ask(gui::Stop{}));
  EXPECT_FALSE(ask(gui::LocalCommand{gui::MarkLoop{}}));
  go_on(Milliseconds(100));
  EXPECT_EQ(session_.playing_view().activity, Activity::Idle);
  EXPECT_EQ(session_.title(), "AUcast");
  EXPECT_FALSE(session_.over());
  EXPECT_FALSE(session_.stands());
  EXPECT_EQ(session_.played().begun, 0U);
  EXPECT_EQ(session_.finish(clock_.now()), nullptr);
}

TEST_F(PlaybackSessionTest, AServerThatAnswersIsRemembered) {
  gui::RemoteSettings lecture;
  lecture.address = "lecture.example.org";
  session_.servers().choose(lecture);
  playback::test::ScriptedSource& source = open_remote();
  go_on(Milliseconds(0));
  EXPECT_TRUE(session_.servers().recent().empty());
  source.now.keyframes_received = 1;
  go_on(Milliseconds(10));
  EXPECT_EQ(session_.servers().recent(), std::vector<std::string>{"lecture.example.org"});
  EXPECT_EQ(session_.servers().to_keep().address, "lecture.example.org");
}

TEST_F(PlaybackSessionTest, AFileIsNoServerToRemember) {
  open_local();
  go_on(Milliseconds(10));
  EXPECT_TRUE(session_.local_view().open);
  EXPECT_TRUE(session_.playing_view().local);
  EXPECT_TRUE(session_.servers().recent().empty());
}

TEST_F(PlaybackSessionTest, StopEndsAServersStreamButOnlyHoldsAFile) {
  open_remote().keyframes.push_back(marked(1, Milliseconds(500)));
  go_on(Milliseconds(10));
  ask(gui::Stop{});
  EXPECT_FALSE(session_.stands());
  EXPECT_FALSE(ask(gui::Resume{}));
  open_local();
  go_on(Milliseconds(10));
  ask(gui::Stop{});
  EXPECT_TRUE(session_.stands());
  EXPECT_TRUE(ask(gui::Resume{}));
}

TEST_F(PlaybackSessionTest, AnotherStreamStopsTheOneBeforeAndForgetsWhatItReceived) {
  playback::test::ScriptedSource& source = open_remote();
  source.keyframes.push_back(marked(1, Milliseconds(500)));
  go_on(Milliseconds(10));
  EXPECT_EQ(session_.keyframe(), 1U);
  EXPECT_EQ(session_.played().begun, 1U);
  open_remote();
  EXPECT_EQ(source.now.end, playback::EndReason::Stopped);
  EXPECT_EQ(session_.keyframe(), 0U);
  EXPECT_EQ(session_.played().begun, 0U);
}

TEST_F(PlaybackSessionTest, SaysWhoEndedTheStream) {
  gui::RemoteSettings lecture;
  lecture.address = "lecture.example.org";
  session_.servers().set(lecture, {});
  playback::test::ScriptedSource& source = open_remote();
  source.keyframes.push_back(marked(1, Milliseconds(100)));
  go_on(Milliseconds(0));
  EXPECT_EQ(session_.playing_view().ended_by, "");
  source.now.end = playback::EndReason::EndOfStream;
  go_on(Milliseconds(200));
  EXPECT_EQ(session_.playing_view().ended_by, "lecture.example.org");
  EXPECT_TRUE(session_.over());
}

TEST_F(PlaybackSessionTest, LiveIsObjectedToForAServersStreamOnly) {
  options_.playback.buffers.low_delay = true;
  open_local();
  go_on(Milliseconds(10));
  EXPECT_EQ(notices_.view().text, "");
  open_remote().keyframes.push_back(marked(1, Milliseconds(100)));
  go_on(Milliseconds(10));
  EXPECT_EQ(notices_.view().text, window_text(LiveObjection::IsClassic));
}

TEST_F(PlaybackSessionTest, WhatTheFaceCannotShowIsLoggedOnce) {
  const test::KeptLog log;
  for (int turn = 0; turn < 2; ++turn) {
    open_local();
    for (int i = 0; i < 20; ++i) go_on(Milliseconds(20));
  }
  EXPECT_EQ(log.said(), "the face '' cannot show AU 1 Inner Brow Raiser\n");
}

TEST_F(PlaybackSessionTest, FinishHandsOutWhatPlayedStopped) {
  open_remote().keyframes.push_back(marked(1, Milliseconds(500)));
  go_on(Milliseconds(10));
  const auto played = session_.finish(clock_.now());
  ASSERT_NE(played, nullptr);
  EXPECT_EQ(played->state(), playback::PlaybackState::Stopped);
  EXPECT_EQ(session_.title(), "AUcast");
}

}  // namespace
}  // namespace aucast::app
