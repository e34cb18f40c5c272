#include "client/app/window/playing/remote_stream.h"

#include <chrono>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "client/playback/source_playback.h"
#include "tests/support/manual_clock.h"
#include "tests/unit/playback/marked.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::app {
namespace {

using playback::EndReason;
using playback::test::marked;
using Server = RemoteStream::Server;

class RemoteStreamTest : public testing::Test {
 protected:
  void open(Server server, const playback::BufferOptions& buffers = {}) {
    auto source = std::make_unique<playback::test::ScriptedSource>();
    source_ = source.get();
    source_->now.connected = true;
    stream_.emplace(std::make_unique<playback::SourcePlayback>(std::move(source),
                                                               playback::SourcePlayback::Options{}),
                    buffers, server);
  }
  /// Plays on as the session does.
  void go_on(Milliseconds time) {
    clock_.advance(time);
    while (const auto keyframe = stream_->playback().advance(clock_.now())) {
      stream_->begun(*keyframe);
    }
    stream_->advanced(clock_.now(), {});
  }
  void receive(int mark, Milliseconds time) {
    source_->keyframes.push_back(marked(mark, time));
    ++source_->now.keyframes_received;
  }
  [[nodiscard]] gui::PlayingView view() const {
    gui::PlayingView view;
    stream_->describe(view);
    return view;
  }

  test::ManualClock clock_;
  playback::test::ScriptedSource* source_ = nullptr;
  std::optional<RemoteStream> stream_;
};

TEST_F(RemoteStreamTest, AServerIsToBeRememberedOnceWhenItAnswers) {
  open(Server::Chosen);
  go_on(Milliseconds(0));
  EXPECT_FALSE(stream_->take_answer());
  receive(1, Milliseconds(100));
  EXPECT_TRUE(stream_->take_answer());
  EXPECT_FALSE(stream_->take_answer());
}

TEST_F(RemoteStreamTest, OnesOwnCameraIsNeitherRememberedNorNamedNorEndedByAnybody) {
  open(Server::OwnCamera);
  source_->now.stream = "camera";
  receive(1, Milliseconds(100));
  go_on(Milliseconds(0));
  EXPECT_FALSE(stream_->take_answer());
  EXPECT_EQ(view().stream, "");
  source_->now.end = EndReason::EndOfStream;
  go_on(Milliseconds(200));
  EXPECT_TRUE(stream_->playback().over());
  EXPECT_FALSE(stream_->ended_by_server());
}

TEST_F(RemoteStreamTest, AServerThatEndsItsStreamIsToldFromAUserWhoLeaves) {
  open(Server::Chosen);
  receive(1, Milliseconds(100));
  go_on(Milliseconds(0));
  source_->now.end = EndReason::EndOfStream;
  go_on(Milliseconds(200));
  EXPECT_TRUE(stream_->ended_by_server());
  open(Server::Chosen);
  receive(1, Milliseconds(100));
  go_on(Milliseconds(0));
  stream_->stop(clock_.now());
  EXPECT_FALSE(stream_->ended_by_server());
  EXPECT_FALSE(stream_->resume(clock_.now())) << "what is over cannot go on";
}

TEST_F(RemoteStreamTest, KeepsWhatItReceivedWithTheTimesItWasPlayedIn) {
  open(Server::Chosen);
  receive(1, Milliseconds(100));
  source_->keyframes.push_back(marked(2));
  go_on(Milliseconds(0));
  EXPECT_TRUE(view().timed);
  go_on(Milliseconds(150));
  EXPECT_FALSE(view().timed);
  const Played played = stream_->played();
  ASSERT_EQ(played.keyframes.size(), 2U);
  EXPECT_EQ(played.begun, 2U);
  EXPECT_EQ(playback::test::mark_of(played.keyframes[1]), 2);
  EXPECT_EQ(played.keyframes[0].time, Milliseconds(100));
  EXPECT_EQ(played.keyframes[1].time, source_->now.keyframe_time);
}

TEST_F(RemoteStreamTest, SaysInHowManySecondsALostServerIsTriedAgain) {
  open(Server::Chosen);
  receive(1, Milliseconds(100));
  go_on(Milliseconds(0));
  EXPECT_FALSE(view().tries_again);
  source_->now.connected = false;
  source_->now.reconnects = 1;
  source_->now.retry_after = std::chrono::seconds(4);
  source_->now.reason = "the connection was lost";
  go_on(Milliseconds(10));
  EXPECT_TRUE(view().tries_again);
  EXPECT_EQ(view().detail, "the connection was lost");
  EXPECT_EQ(view().again_s, 4);
  EXPECT_TRUE(view().stale) << "the face is the last of a server that is gone";
  go_on(Milliseconds(2'500));
  EXPECT_EQ(view().again_s, 2);
  go_on(Milliseconds(9'000));
  EXPECT_EQ(view().again_s, 0);
}

TEST_F(RemoteStreamTest, IsLookedAtOftenOnlyWhereKeyframesComeJustInTime) {
  open(Server::Chosen);
  EXPECT_EQ(stream_->idle_time(), Milliseconds(50));
  playback::BufferOptions live;
  live.low_delay = true;
  open(Server::Chosen, live);
  EXPECT_EQ(stream_->idle_time(), kFrameMax);
  receive(1, Milliseconds(100));
  go_on(Milliseconds(0));
  EXPECT_EQ(stream_->idle_time(), Milliseconds(2));
  stream_->stop(clock_.now());
  EXPECT_EQ(stream_->idle_time(), PlayingStream::kIdle);
}

TEST_F(RemoteStreamTest, ItsTitleSaysWhyItEndedWhenNothingIsHeardAnyMore) {
  open(Server::Chosen);
  source_->now.detail = "the server has no such stream";
  source_->now.end = EndReason::Refused;
  go_on(Milliseconds(0));
  EXPECT_EQ(stream_->title("AUcast", false).find("no such stream"), std::string::npos);
  const std::string title = stream_->title("AUcast", true);
  EXPECT_EQ(title.find("AUcast - "), 0U);
  EXPECT_NE(title.find(": the server has no such stream"), std::string::npos) << title;
}

TEST_F(RemoteStreamTest, ItsTitleDoesNotCallPlayingWhatIsStillBeingConnectedTo) {
  open(Server::Chosen);
  EXPECT_EQ(stream_->title("AUcast", false), "AUcast - playing");
  source_->now.connected = false;
  EXPECT_EQ(stream_->title("AUcast", false), "AUcast - connecting");
  source_->now.reconnects = 1;
  EXPECT_EQ(stream_->title("AUcast", false), "AUcast - reconnecting");
}

}  // namespace
}  // namespace aucast::app
