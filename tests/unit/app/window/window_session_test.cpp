#include "client/app/window/window_session.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>

#include "client/app/window/settings/window_settings.h"
#include "common/files.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::app {
namespace {

using gui::Activity;
using playback::EndReason;
using playback::test::ScriptedSource;

using WindowSessionTest = PlayedSession;

TEST_F(WindowSessionTest, WithoutASourceTheFaceIsNeutral) {
  open_nothing();
  EXPECT_EQ(model().playing.activity, Activity::Idle);
  EXPECT_EQ(model().playing.state, "no connection");
  EXPECT_EQ(session_->playback().title(), "AUcast");
  EXPECT_FALSE(session_->playback().over());
  EXPECT_GE(session_->idle_time(clock_.now()), Milliseconds(250));
  EXPECT_EQ(session_->face().activations(clock_.now()),
            std::vector<float>(assets_->face.channels.size()));
}

TEST_F(WindowSessionTest, TheFolderForPicturesHasAWholePath) {
  open_nothing();
  const std::filesystem::path here = std::filesystem::current_path();
  EXPECT_EQ(std::filesystem::path(model().picture_folder).parent_path(), here);
  gui::PictureSettings pictures = session_->settings().pictures();
  pictures.folder = "out";
  ask(gui::ChangePictures{pictures});
  EXPECT_EQ(model().picture_folder, here / "out");
  pictures.folder = "/tmp";
  ask(gui::ChangePictures{pictures});
  EXPECT_EQ(model().picture_folder, "/tmp");
}

TEST_F(WindowSessionTest, PlaysAndShowsWhatCameAndWhatTheRulesMadeOfIt) {
  open({frame({{51, Side::Both, 100}, {52, Side::Both, 40}})});
  go_on(Milliseconds(0));
  ASSERT_EQ(model().playing.aus.size(), 2U);
  EXPECT_EQ(model().playing.aus[0].received_percent, 100);
  EXPECT_EQ(model().playing.aus[0].shown_percent, 0) << "it has only begun";
  EXPECT_EQ(model().playing.aus[0].why, "opposition: 51 100 % and 52 40 %: 51 60 %, 52 gone");
  EXPECT_EQ(model().playing.keyframe, "keyframe 1");
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(2));
  go_on(Milliseconds(50));
  EXPECT_EQ(model().playing.aus[0].shown_percent, 30);
  go_on(Milliseconds(50));
  EXPECT_FLOAT_EQ(shown("head_turn_left"), 0.6F);
  EXPECT_EQ(model().playing.aus[0].shown_percent, 60);
}

TEST_F(WindowSessionTest, ExportsWhatWasReceivedAndNotTheEasingToNeutral) {
  open({frame({{12, Side::Both, 100}}), frame({{4, Side::Both, 50}})});
  for (int step = 0; step < 3; ++step) go_on(Milliseconds(100));
  EXPECT_FALSE(model().playing.eased);
  go_on(options_.playback.hold);
  go_on(Milliseconds(500));
  EXPECT_TRUE(model().playing.eased);
  source_->keyframes.push_back({frame({{26, Side::Both, 100}}), Milliseconds(300)});
  go_on(Milliseconds(10));
  EXPECT_FALSE(model().playing.eased);
  const test::TempFolder folder;
  const auto file = folder.path() / "exported.txt";
  ask(gui::Browse{gui::Purpose::ExportKeyframes});
  ask(gui::ChooseFile{file.string()});
  EXPECT_EQ(*read_file(file), "Beg_Stream\n12;100\n4:50;100\n26;300\nEnd_Stream\n");
}

TEST_F(WindowSessionTest, PauseHoldsTheFaceAndResumeGoesOn) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(50));
  const float half = shown("jaw");
  EXPECT_GT(half, 0);
  ask(gui::Pause{});
  go_on(Milliseconds(5000));
  EXPECT_EQ(shown("jaw"), half);
  EXPECT_EQ(model().playing.activity, Activity::Paused);
  session_->toggle_pause(clock_.now());
  go_on(Milliseconds(50));
  EXPECT_FLOAT_EQ(shown("jaw"), 2 * half);
}

TEST_F(WindowSessionTest, StopKeepsTheFace) {
  open({frame({{26, Side::Both, 100}}), frame({})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(50));
  const float half = shown("jaw");
  ask(gui::Stop{});
  go_on(Milliseconds(1000));
  EXPECT_EQ(shown("jaw"), half);
  EXPECT_TRUE(session_->playback().over());
  EXPECT_EQ(model().playing.activity, Activity::Over);
  EXPECT_EQ(source_->now.end, EndReason::Stopped);
  source_->now.detail = "stopped by the user";
  EXPECT_EQ(model().playing.detail, "") << "nothing went wrong";
}

TEST_F(WindowSessionTest, ALostConnectionKeepsTheLastFaceAndSaysSo) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  source_->now.end = EndReason::ConnectionLost;
  source_->now.detail = "the server has gone";
  go_on(Milliseconds(100));
  go_on(Milliseconds(100));
  EXPECT_GT(shown("jaw"), 0);
  EXPECT_TRUE(model().playing.stale);
  EXPECT_EQ(model().playing.state, "lost");
  EXPECT_EQ(model().playing.detail, "the server has gone");
  EXPECT_FALSE(model().playing.eased);
}

TEST_F(WindowSessionTest, TheTimeToTheNextAttemptIsCountedDown) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  source_->now.connected = false;
  source_->now.reconnects = 1;
  source_->now.reason = "lecture.example.org: the connection was lost";
  source_->now.retry_after = Milliseconds(30'000);
  go_on(Milliseconds(100));
  EXPECT_TRUE(model().playing.tries_again);
  EXPECT_EQ(model().playing.detail, source_->now.reason);
  EXPECT_EQ(model().playing.again_s, 30);
  go_on(Milliseconds(1'500));
  EXPECT_EQ(model().playing.again_s, 29);
  go_on(Milliseconds(40'000));
  EXPECT_EQ(model().playing.again_s, 0);
  source_->now.reconnects = 2;
  go_on(Milliseconds(100));
  EXPECT_EQ(model().playing.again_s, 30);
}

TEST_F(WindowSessionTest, AStreamThatTheServerEndsSaysWhoHasEndedIt) {
  open({frame({{26, Side::Both, 100}})});
  gui::KeptSettings settings;
  settings.remote.address = "venus";
  session_->begin_with(settings, {}, clock_.now());
  go_on(Milliseconds(0));
  source_->now.end = EndReason::EndOfStream;
  go_on(Milliseconds(200));
  EXPECT_EQ(model().playing.ended_by, "venus");
}

TEST_F(WindowSessionTest, AFaceThatIsLostForLongGoesToNeutralAndSaysSo) {
  options_.playback.hold = Milliseconds(2000);
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  source_->now.end = EndReason::ConnectionLost;
  go_on(Milliseconds(250));
  const float held = shown("jaw");
  go_on(Milliseconds(2000));
  EXPECT_EQ(shown("jaw"), held) << "it sets out";
  EXPECT_TRUE(model().playing.eased);
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(20)) << "and is drawn on its way";
  go_on(Milliseconds(500));
  EXPECT_FLOAT_EQ(shown("jaw"), held / 2);
  go_on(Milliseconds(500));
  EXPECT_EQ(shown("jaw"), 0);
  EXPECT_EQ(model().playing.state, "lost");
  EXPECT_TRUE(model().playing.aus.empty());
  EXPECT_GT(session_->idle_time(clock_.now()), Milliseconds(20));
}

TEST_F(WindowSessionTest, TheDelayOfALiveStreamIsShown) {
  open({frame({{26, Side::Both, 100}})});
  source_->now.connected = true;
  source_->now.delay = Milliseconds(300);
  source_->keyframes.front().arrived = clock_.now();
  go_on(Milliseconds(10));
  EXPECT_EQ(model().playing.delay, "") << "nothing is measured yet";
  go_on(Milliseconds(250));
  EXPECT_EQ(model().playing.delay, "260 ms (at most 260, wanted 300)");
}

TEST_F(WindowSessionTest, MixerRulesAndInterpolationChangeDuringPlay) {
  const AuFrame opposed = frame({{51, Side::Both, 100}, {52, Side::Both, 40}});
  open({opposed, opposed});
  go_on(Milliseconds(0));
  gui::AnimationSettings settings = model().animation;
  EXPECT_EQ(settings.rules, "facs");
  settings.rules = "none";
  settings.mixer = face::Mixer::Average;
  settings.interpolation = playback::Interpolation::Cosine;
  ask(gui::ChangeAnimation{settings});
  EXPECT_EQ(model().animation, settings);
  go_on(Milliseconds(100));
  EXPECT_EQ(model().playing.aus[0].shown_percent, 100);
  go_on(Milliseconds(100));
  EXPECT_FLOAT_EQ(shown("head_turn_right"), 0.4F);
}

TEST_F(WindowSessionTest, OtherRulesAreSeenOnAFaceThatStands) {
  open({frame({{51, Side::Both, 100}, {52, Side::Both, 40}})});
  go_on(Milliseconds(0));
  source_->now.end = EndReason::EndOfStream;
  go_on(Milliseconds(100));
  go_on(Milliseconds(0));
  ASSERT_TRUE(session_->playback().over());
  EXPECT_EQ(shown("head_turn_right"), 0);
  gui::AnimationSettings settings = model().animation;
  settings.rules = "none";
  ask(gui::ChangeAnimation{settings});
  EXPECT_FLOAT_EQ(shown("head_turn_right"), 0.4F);
}

TEST_F(WindowSessionTest, AnAuThatTheFaceLacksIsNotShown) {
  ASSERT_FALSE(assets_->face.recordings.contains(90));
  open({frame({{90, Side::Both, 100}})});
  go_on(Milliseconds(0));
  ASSERT_EQ(model().playing.aus.size(), 1U);
  EXPECT_EQ(model().playing.aus[0].received_percent, 100);
  EXPECT_EQ(model().playing.aus[0].shown_percent, 0);
  EXPECT_EQ(model().playing.aus[0].why, "this face has no AU 90");
}

TEST_F(WindowSessionTest, RulesThatAreNotThereChangeNothing) {
  open_nothing();
  gui::AnimationSettings settings = model().animation;
  settings.rules = "no such rules";
  ask(gui::ChangeAnimation{settings});
  EXPECT_EQ(model().animation.rules, "facs");
  EXPECT_TRUE(model().notice.bad) << "the user sees why the choice springs back";
}

TEST_F(WindowSessionTest, BlinkingClosesTheLidsNowAndThen) {
  open_nothing();
  gui::RenderingSettings settings;
  settings.blinking = true;
  ask(gui::ChangeRendering{settings});
  float largest = 0;
  for (int i = 0; i < 250; ++i) {
    clock_.advance(Milliseconds(20));
    largest = std::max(largest, shown("left_lid_close"));
  }
  EXPECT_EQ(largest, 1);
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(20));
}

TEST_F(WindowSessionTest, IdleLifeMovesTheEyesAndNothingElseDoes) {
  const auto gaze_of_ten_seconds = [&] {
    float largest = 0;
    for (int i = 0; i < 500; ++i) {
      clock_.advance(Milliseconds(20));
      largest = std::max({largest, shown("left_gaze_left"), shown("left_gaze_right")});
    }
    return largest;
  };
  open_nothing();
  EXPECT_EQ(gaze_of_ten_seconds(), 0);
  options_.playback.idle_seed = 3;
  open_nothing();
  EXPECT_GT(gaze_of_ten_seconds(), 0.02F);
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(20));
}

TEST_F(WindowSessionTest, HairSwingsAfterTheHeadWhileItPlaysAndSettlesWhenItPauses) {
  open({frame({{51, Side::Both, 100}}), {}});
  for (int i = 0; i < 10; ++i) {
    go_on(Milliseconds(10));
    static_cast<void>(shown("head_turn_left"));
  }
  EXPECT_LT(session_->face().hair().turn, -0.2F);
  session_->toggle_pause(clock_.now());
  const float turned = shown("head_turn_left");
  EXPECT_LT(session_->face().hair().turn, -0.2F);
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(20));
  go_on(pipeline::HairSwing::kMemory);
  EXPECT_EQ(shown("head_turn_left"), turned);
  EXPECT_EQ(session_->face().hair(), face::HairSway{});
}

TEST_F(WindowSessionTest, EveryChannelStandsWithItsRegionOfTheFace) {
  open_nothing();
  for (const gui::ChannelGroup& group : model().editor.groups) {
    EXPECT_NE(group.name, "Other");
    for (const gui::ChannelRow& row : group.rows) {
      EXPECT_EQ(group.name == "Head", row.name.starts_with("head ")) << row.name;
      if (row.name == "crease forehead inner") {
        EXPECT_EQ(group.name, "Forehead and brows");
      }
    }
  }
}

TEST_F(WindowSessionTest, AnEmptyViewIsNotKeptForTheNextStart) {
  open_nothing();
  gui::KeptSettings settings;
  settings.rendering.layers.textured = false;
  session_->begin_with(settings, "", clock_.now());
  EXPECT_TRUE(session_->settings().rendering().layers.textured);
  settings.rendering.layers.wireframe = true;
  session_->begin_with(settings, "", clock_.now());
  EXPECT_FALSE(session_->settings().rendering().layers.textured);
}

TEST_F(WindowSessionTest, ABufferThatWaitsForATimeHasNoThreshold) {
  open({frame({})});
  gui::RemoteSettings settings{"127.0.0.1", 1, 50, 20, 30, 0};
  settings.behind = gui::Behind::Auto;
  ask(gui::Connect{settings});
  EXPECT_EQ(model().playing.receiver.threshold_percent, 0);
}

TEST_F(WindowSessionTest, ConnectReplacesWhatPlayedAndHoldsTheFace) {
  open({frame({{26, Side::Both, 100}}), frame({})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(50));
  const float half = shown("jaw");
  // Nothing listens on this port of this host.
  ask(gui::Connect{{"127.0.0.1", 1, 50, 20, 30, 0}});
  EXPECT_EQ(shown("jaw"), half);
  EXPECT_EQ(model().playing.receiver.capacity, 50U);
  EXPECT_EQ(model().playing.receiver.threshold_percent, 30);
  EXPECT_TRUE(model().playing.keyframe.empty());
  EXPECT_TRUE(model().playing.aus.empty());
  const auto last = session_->finish(clock_.now());
  ASSERT_NE(last, nullptr);
}

TEST_F(WindowSessionTest, OnlyAnAddressThatAnsweredIsAmongTheRecentOnes) {
  options_.playback.endpoint = "lecture.example.org";
  open({frame({{26, Side::Both, 100}})});
  session_->begin_with(WindowSettings(options_, {}).in_force(), "", clock_.now());
  go_on(Milliseconds(0));
  EXPECT_TRUE(session_->playback().servers().recent().empty());
  source_->now.keyframes_received = 1;
  go_on(Milliseconds(0));
  EXPECT_EQ(session_->playback().servers().recent(),
            std::vector<std::string>{"lecture.example.org"});
  ask(gui::Connect{{"127.0.0.1", 1, 50, 20, 30, 0}});  // nothing listens there
  go_on(Milliseconds(100));
  EXPECT_EQ(session_->playback().servers().recent(),
            std::vector<std::string>{"lecture.example.org"});
}

TEST_F(WindowSessionTest, KeyframesWithTimesOfTheirOwnMakeTheSpeedUseless) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  EXPECT_TRUE(model().playing.timed);
}

TEST_F(WindowSessionTest, OtherRulesWhileConnectingLeaveNothingOfThoseBefore) {
  open({frame({{51, Side::Both, 100}, {52, Side::Both, 40}})});  // a rule fires
  go_on(Milliseconds(0));
  ASSERT_FALSE(model().playing.aus.empty());
  ask(gui::Connect{{"127.0.0.1", 1, 50, 20, 30, 0}});
  gui::AnimationSettings settings = model().animation;
  settings.rules = "none";
  ask(gui::ChangeAnimation{settings});
  EXPECT_EQ(model().animation.rules, "none");
  EXPECT_TRUE(model().playing.aus.empty());
  static_cast<void>(session_->finish(clock_.now()));
}

TEST_F(WindowSessionTest, FinishCompletesTheStatistics) {
  open({frame({{26, Side::Both, 100}}), frame({})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(100));
  const auto last = session_->finish(clock_.now());
  EXPECT_EQ(last.get(), playback_);
  EXPECT_EQ(stats_.keyframes_played, 1U);
  EXPECT_DOUBLE_EQ(stats_.media_seconds, 0.1);
}

}  // namespace
}  // namespace aucast::app
