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

AuFrame frame(std::initializer_list<AuTerm> terms) {
  return frame_from_terms({terms.begin(), terms.size()});
}

/// The default face, driven by a source that the test fills by hand.
class WindowSessionTest : public SessionOnDefaultFace {
 protected:
  void SetUp() override { options_.playback.endpoint = "127.0.0.1:4650"; }

  /// Opens a source that has these keyframes of 100 ms.
  void open(const std::vector<AuFrame>& keyframes) {
    auto source = std::make_unique<ScriptedSource>();
    source_ = source.get();
    source_->now.connected = true;
    for (const AuFrame& aus : keyframes) source_->keyframes.push_back({aus, Milliseconds(100)});
    const playback::SourcePlayback::Options how{options_.playback.speed, options_.playback.hold};
    auto playback = std::make_unique<playback::SourcePlayback>(std::move(source), how);
    playback_ = playback.get();
    session_.emplace(*assets_, options_, std::move(playback), stats_);
  }
  void open_nothing() { session_.emplace(*assets_, options_, nullptr, stats_); }

  void ask(const gui::GuiCommand& command) { session_->apply(command, clock_.now()); }
  [[nodiscard]] static int channel(const char* name) {
    return static_cast<int>(*assets_->face.channel_index(name));
  }
  [[nodiscard]] static std::size_t expression(const char* name) {
    const auto& all = assets_->expressions;
    const auto found =
        std::find_if(all.begin(), all.end(), [name](const auto& one) { return one.name == name; });
    return static_cast<std::size_t>(found - all.begin());
  }

  ScriptedSource* source_ = nullptr;
  playback::Playback* playback_ = nullptr;  ///< of source_
};

TEST_F(WindowSessionTest, WithoutASourceTheFaceIsNeutral) {
  open_nothing();
  EXPECT_EQ(model().remote.activity, Activity::Idle);
  EXPECT_EQ(model().remote.state, "no connection");
  EXPECT_EQ(session_->title(), "AUcast");
  EXPECT_FALSE(session_->over());
  EXPECT_GE(session_->idle_time(clock_.now()), Milliseconds(250));
  EXPECT_EQ(session_->activations(clock_.now()), std::vector<float>(assets_->face.channels.size()));
}

TEST_F(WindowSessionTest, PlaysAndShowsWhatCameAndWhatTheRulesMadeOfIt) {
  open({frame({{51, Side::Both, 100}, {52, Side::Both, 40}})});
  go_on(Milliseconds(0));
  ASSERT_EQ(model().remote.aus.size(), 2U);
  EXPECT_EQ(model().remote.aus[0].received_percent, 100);
  EXPECT_EQ(model().remote.aus[0].shown_percent, 0) << "it has only begun";
  EXPECT_EQ(model().remote.aus[0].why, "opposition: 51 100 % and 52 40 %: 51 60 %, 52 gone");
  EXPECT_EQ(model().remote.keyframe, "keyframe 1");
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(2));
  go_on(Milliseconds(50));
  EXPECT_EQ(model().remote.aus[0].shown_percent, 30);
  go_on(Milliseconds(50));
  EXPECT_FLOAT_EQ(shown("head_turn_left"), 0.6F);
  EXPECT_EQ(model().remote.aus[0].shown_percent, 60);
}

TEST_F(WindowSessionTest, ExportsWhatWasReceivedAndNotTheEasingToNeutral) {
  open({frame({{12, Side::Both, 100}}), frame({{4, Side::Both, 50}})});
  for (int step = 0; step < 3; ++step) go_on(Milliseconds(100));
  EXPECT_FALSE(model().remote.eased);
  go_on(options_.playback.hold);
  go_on(Milliseconds(500));
  EXPECT_TRUE(model().remote.eased);
  source_->keyframes.push_back({frame({{26, Side::Both, 100}}), Milliseconds(300)});
  go_on(Milliseconds(10));
  EXPECT_FALSE(model().remote.eased);
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
  EXPECT_EQ(model().remote.activity, Activity::Paused);
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
  EXPECT_TRUE(session_->over());
  EXPECT_EQ(model().remote.activity, Activity::Over);
  EXPECT_EQ(source_->now.end, EndReason::Stopped);
  source_->now.detail = "stopped by the user";
  EXPECT_EQ(model().remote.detail, "") << "nothing went wrong";
}

TEST_F(WindowSessionTest, ALostConnectionKeepsTheLastFaceAndSaysSo) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  source_->now.end = EndReason::ConnectionLost;
  source_->now.detail = "the server has gone";
  go_on(Milliseconds(100));
  go_on(Milliseconds(100));
  EXPECT_GT(shown("jaw"), 0);
  EXPECT_TRUE(model().remote.stale);
  EXPECT_EQ(model().remote.state, "lost");
  EXPECT_EQ(model().remote.detail, "the server has gone");
  EXPECT_FALSE(model().remote.eased);
}

TEST_F(WindowSessionTest, TheTimeToTheNextAttemptIsCountedDown) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  source_->now.connected = false;
  source_->now.reconnects = 1;
  source_->now.reason = "lecture.example.org: the connection was lost";
  source_->now.retry_after = Milliseconds(30'000);
  go_on(Milliseconds(100));
  EXPECT_TRUE(model().remote.tries_again);
  EXPECT_EQ(model().remote.detail, source_->now.reason);
  EXPECT_EQ(model().remote.again_s, 30);
  go_on(Milliseconds(1'500));
  EXPECT_EQ(model().remote.again_s, 29);
  go_on(Milliseconds(40'000));
  EXPECT_EQ(model().remote.again_s, 0);
  source_->now.reconnects = 2;
  go_on(Milliseconds(100));
  EXPECT_EQ(model().remote.again_s, 30);
}

TEST_F(WindowSessionTest, AStreamThatTheServerEndsSaysWhoHasEndedIt) {
  open({frame({{26, Side::Both, 100}})});
  gui::KeptSettings settings;
  settings.remote.address = "venus";
  session_->begin_with(settings, {}, clock_.now());
  go_on(Milliseconds(0));
  source_->now.end = EndReason::EndOfStream;
  go_on(Milliseconds(200));
  EXPECT_EQ(model().remote.ended_by, "venus");
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
  EXPECT_TRUE(model().remote.eased);
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(20)) << "and is drawn on its way";
  go_on(Milliseconds(500));
  EXPECT_FLOAT_EQ(shown("jaw"), held / 2);
  go_on(Milliseconds(500));
  EXPECT_EQ(shown("jaw"), 0);
  EXPECT_EQ(model().remote.state, "lost");
  EXPECT_TRUE(model().remote.aus.empty());
  EXPECT_GT(session_->idle_time(clock_.now()), Milliseconds(20));
}

TEST_F(WindowSessionTest, TheDelayOfALiveStreamIsShown) {
  open({frame({{26, Side::Both, 100}})});
  source_->now.connected = true;
  source_->now.delay = Milliseconds(300);
  source_->keyframes.front().arrived = clock_.now();
  go_on(Milliseconds(10));
  EXPECT_EQ(model().remote.delay, "") << "nothing is measured yet";
  go_on(Milliseconds(250));
  EXPECT_EQ(model().remote.delay, "260 ms (at most 260, wanted 300)");
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
  EXPECT_EQ(model().remote.aus[0].shown_percent, 100);
  go_on(Milliseconds(100));
  EXPECT_FLOAT_EQ(shown("head_turn_right"), 0.4F);
}

TEST_F(WindowSessionTest, OtherRulesAreSeenOnAFaceThatStands) {
  open({frame({{51, Side::Both, 100}, {52, Side::Both, 40}})});
  go_on(Milliseconds(0));
  source_->now.end = EndReason::EndOfStream;
  go_on(Milliseconds(100));
  go_on(Milliseconds(0));
  ASSERT_TRUE(session_->over());
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
  ASSERT_EQ(model().remote.aus.size(), 1U);
  EXPECT_EQ(model().remote.aus[0].received_percent, 100);
  EXPECT_EQ(model().remote.aus[0].shown_percent, 0);
  EXPECT_EQ(model().remote.aus[0].why, "this face has no AU 90");
}

TEST_F(WindowSessionTest, RulesThatAreNotThereChangeNothing) {
  open_nothing();
  gui::AnimationSettings settings = model().animation;
  settings.rules = "no such rules";
  ask(gui::ChangeAnimation{settings});
  EXPECT_EQ(model().animation.rules, "facs");
  EXPECT_TRUE(model().notice.bad) << "the user sees why the choice springs back";
}

TEST_F(WindowSessionTest, AnExpressionIsReachedFromTheFaceAsItIs) {
  open_nothing();
  ask(gui::SetChannel{channel("jaw"), 2, false});
  ask(gui::ShowExpression{expression("happiness")});
  EXPECT_EQ(shown("jaw"), 2);
  clock_.advance(Milliseconds(125));
  EXPECT_FLOAT_EQ(shown("jaw"), 1);
  clock_.advance(Milliseconds(125));
  EXPECT_EQ(shown("jaw"), 0);
  EXPECT_GT(shown("left_zygomaticus_major"), 0.5F);
  EXPECT_TRUE(model().editor.active);
}

TEST_F(WindowSessionTest, AnExpressionIsNotChosenAnyMoreWhenAnotherFaceIsShown) {
  open({AuFrame{}, frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  ask(gui::ShowExpression{expression("happiness")});
  EXPECT_GE(model().expressions.chosen, 0);
  EXPECT_FALSE(model().editor.compound.empty());
  ask(gui::Resume{});
  EXPECT_FALSE(model().editor.active);
  EXPECT_EQ(model().expressions.chosen, -1);
  EXPECT_EQ(model().expressions.aus, "");
  EXPECT_TRUE(model().editor.compound.empty());
}

TEST_F(WindowSessionTest, AnExpressionIsShownAsStronglyAsAsked) {
  open_nothing();
  EXPECT_EQ(model().expressions.chosen, -1);
  ask(gui::ChangeStrength{40, false});
  EXPECT_FALSE(model().editor.active) << "nothing is chosen yet";
  const std::size_t happy = expression("happiness");
  ask(gui::ShowExpression{happy});
  EXPECT_EQ(model().expressions.chosen, static_cast<int>(happy));
  EXPECT_EQ(model().expressions.aus, "6:40,12:40");
  ASSERT_EQ(model().editor.compound.size(), 2U);
  EXPECT_EQ(model().editor.compound[1].received_percent, 40);
  ask(gui::ChangeStrength{100, false});
  clock_.advance(Milliseconds(250));
  const float whole = shown("left_zygomaticus_major");
  ask(gui::ChangeStrength{70, true});
  ask(gui::ChangeStrength{50, true});
  clock_.advance(Milliseconds(250));
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), whole / 2);
  ask(gui::Undo{});
  EXPECT_EQ(model().expressions.chosen, -1) << "the face is another one now";
  EXPECT_EQ(model().expressions.aus, "");
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), whole * 0.4F) << "a drag is one step";
}

TEST_F(WindowSessionTest, AMacroIsShownAsStronglyAsAsked) {
  open_nothing();
  ask(gui::ChangeStrength{50, false});
  ask(gui::ShowExpression{expression("waters-happiness")});
  clock_.advance(Milliseconds(250));
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), 0.5F);
  EXPECT_EQ(model().expressions.aus, "") << "muscles are no AUs";
}

TEST_F(WindowSessionTest, TheComposerTakesTheFaceThatIsShown) {
  open_nothing();
  EXPECT_TRUE(model().composer.can_take) << "the neutral face of what does not play yet";
  ask(gui::SetChannel{channel("jaw"), 2, false});
  EXPECT_FALSE(model().composer.can_take) << "muscles are no AUs";
  ask(gui::ComposerCommand(gui::ComposeShown{}));
  EXPECT_TRUE(model().editor.active);
  ask(gui::ChangeStrength{60, false});
  ask(gui::ShowExpression{expression("happiness")});
  ask(gui::ComposerCommand(gui::ComposeShown{}));
  EXPECT_TRUE(model().composer.active);
  EXPECT_FALSE(model().composer.can_take) << "it is its own";
  ASSERT_EQ(model().composer.aus.size(), 2U);
  EXPECT_EQ(model().composer.aus[0].number, 6);
  EXPECT_EQ(model().composer.aus[0].left_percent, 60);
  ASSERT_TRUE(session_->aus_shown().has_value());
  EXPECT_FLOAT_EQ(session_->aus_shown()->right[12], 0.6F);
}

TEST_F(WindowSessionTest, EveryKindOfExpressionHasOneButton) {
  using gui::ExpressionKind;
  open_nothing();
  const auto all = model().expressions.buttons;
  EXPECT_EQ(all.size(), assets_->expressions.size());
  std::set<std::string> labels;
  int macros = 0;
  for (const gui::ExpressionButton& one : all) {
    macros += one.kind == ExpressionKind::Macro ? 1 : 0;
    if (one.kind == ExpressionKind::Macro) continue;
    EXPECT_TRUE(labels.insert(one.label).second) << one.label << " is there twice";
  }
  EXPECT_EQ(all.front().kind, ExpressionKind::Main);
  EXPECT_EQ(macros, 6);
}

TEST_F(WindowSessionTest, SeveralAusTogetherGoThroughRulesAndMixer) {
  open_nothing();
  ask(gui::ShowAus{"51,52:40"});
  clock_.advance(Milliseconds(250));
  EXPECT_FLOAT_EQ(shown("head_turn_left"), 0.6F);
  EXPECT_TRUE(model().editor.active);
  ASSERT_EQ(model().editor.compound.size(), 2U);
  EXPECT_EQ(model().editor.compound[0].label, "51");
  EXPECT_EQ(model().editor.compound[0].shown_percent, 60);
  EXPECT_EQ(model().editor.compound[1].shown_percent, 0);
  EXPECT_NE(model().editor.compound[1].why, "");
  ask(gui::NeutralFace{});
  EXPECT_TRUE(model().editor.compound.empty()) << "the face is another one now";
  ask(gui::ShowAus{"no AUs"});
  EXPECT_TRUE(model().notice.bad);
  ask(gui::ShowAus{"12"});
  EXPECT_EQ(model().notice.text, "") << "the mistake is mended";
}

TEST_F(WindowSessionTest, EveryAuHasItsMusclesAndWhatItLooksLike) {
  open_nothing();
  ASSERT_NE(model().known_aus, nullptr);
  EXPECT_GT(model().known_aus->size(), 40U);
  for (const gui::AuEntry& entry : *model().known_aus) {
    EXPECT_FALSE(entry.name.empty()) << entry.number;
    EXPECT_FALSE(entry.muscles.empty()) << entry.number;
    EXPECT_FALSE(entry.looks.empty()) << entry.number;
  }
}

TEST_F(WindowSessionTest, UndoIsOfWhatTheFaceShows) {
  open_nothing();
  ask(gui::SetChannel{channel("jaw"), 2, false});
  session_->undo(clock_.now());
  EXPECT_EQ(shown("jaw"), 0);
  session_->redo(clock_.now());
  EXPECT_EQ(shown("jaw"), 2);
  ask(gui::ComposerCommand(gui::ComposeAu{51, 100, 100, false}));
  session_->undo(clock_.now());
  EXPECT_EQ(shown("head_turn_left"), 0);
  EXPECT_FALSE(model().composer.unsaved);
  EXPECT_TRUE(model().editor.unsaved);
}

TEST_F(WindowSessionTest, AMacroSetsItsMuscles) {
  open_nothing();
  ask(gui::ShowExpression{expression("waters-happiness")});
  clock_.advance(Milliseconds(250));
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), 1.0F);
  EXPECT_FLOAT_EQ(shown("right_zygomaticus_major"), 1.1F);
}

TEST_F(WindowSessionTest, EditingHoldsWhatPlaysAndResumeGivesTheFaceBack) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(50));
  const float half = shown("jaw");
  ask(gui::SetChannel{channel("jaw"), 4, false});
  EXPECT_EQ(shown("jaw"), 4);
  EXPECT_EQ(model().remote.activity, Activity::Paused);
  ask(gui::Resume{});
  EXPECT_EQ(shown("jaw"), half);
  EXPECT_FALSE(model().editor.active);
}

TEST_F(WindowSessionTest, ChannelsThatAreNotThereAreIgnored) {
  open_nothing();
  ask(gui::SetChannel{-1, 1, false});
  ask(gui::SetChannel{100'000, 1, false});
  ask(gui::ShowExpression{100'000});
  EXPECT_FALSE(model().editor.active);
}

TEST_F(WindowSessionTest, AnEditedAuIsSavedInTheUsersFolderAndPlayed) {
  const test::TempFolder home;
  ASSERT_EQ(::setenv("XDG_DATA_HOME", home.path().c_str(), 1), 0);
  open({frame({{12, Side::Both, 100}})});
  ask(gui::LoadAu{12});
  EXPECT_EQ(model().editor.au, 12);
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  EXPECT_TRUE(model().editor.unsaved);
  ask(gui::SaveAu{12});
  EXPECT_FALSE(model().editor.unsaved);
  const std::filesystem::path copy = home.path() / "aucast" / "faces" / "default";
  EXPECT_NE(model().notice.text.find(copy.string()), std::string::npos);
  EXPECT_EQ(session_->kept().face, copy.string()) << "the next start shows it";
  const auto face = face::load_face(copy, assets_->data_folder);
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_EQ(face->recordings.at(12).activation[*face->channel_index("jaw")], 3.5F);
  ask(gui::Resume{});
  go_on(Milliseconds(0));
  go_on(Milliseconds(100));
  EXPECT_FLOAT_EQ(shown("jaw"), 3.5F);
  ASSERT_EQ(::unsetenv("XDG_DATA_HOME"), 0);
  session_.reset();
  SetUpTestSuite();  // the face of the assets is the copy now
}

TEST_F(WindowSessionTest, ASavingThatFailsIsSaidAndLosesNothing) {
  const test::TempFolder home;
  const auto file = home.write("not a folder", "");
  ASSERT_EQ(::setenv("XDG_DATA_HOME", file.c_str(), 1), 0);
  open_nothing();
  ask(gui::LoadAu{12});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::SaveAu{12});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("cannot be copied"), std::string::npos);
  EXPECT_TRUE(model().editor.unsaved);
  EXPECT_EQ(shown("jaw"), 3.5F);
  ASSERT_EQ(::unsetenv("XDG_DATA_HOME"), 0);
}

TEST_F(WindowSessionTest, LeavingAsksWhenSomethingIsNotSaved) {
  open_nothing();
  ask(gui::SetChannel{channel("jaw"), 1, false});
  session_->ask_to_leave();
  EXPECT_FALSE(session_->leaving());
  EXPECT_TRUE(model().asks_to_leave);
  ask(gui::Leave{false});
  EXPECT_FALSE(session_->leaving());
  EXPECT_FALSE(model().asks_to_leave);
  ask(gui::Undo{});
  session_->ask_to_leave();
  EXPECT_TRUE(session_->leaving());
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
  EXPECT_GT(gaze_of_ten_seconds(), 0.02F);
  EXPECT_LE(session_->idle_time(clock_.now()), Milliseconds(20));
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
  EXPECT_TRUE(session_->rendering().layers.textured);
  settings.rendering.layers.wireframe = true;
  session_->begin_with(settings, "", clock_.now());
  EXPECT_FALSE(session_->rendering().layers.textured);
}

TEST_F(WindowSessionTest, ConnectReplacesWhatPlayedAndHoldsTheFace) {
  open({frame({{26, Side::Both, 100}}), frame({})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(50));
  const float half = shown("jaw");
  // Nothing listens on this port of this host.
  ask(gui::Connect{{"127.0.0.1", 1, 50, 20, 30, 0}});
  EXPECT_EQ(shown("jaw"), half);
  EXPECT_EQ(model().remote.receiver.capacity, 50U);
  EXPECT_EQ(model().remote.receiver.threshold_percent, 30);
  EXPECT_TRUE(model().remote.keyframe.empty());
  EXPECT_TRUE(model().remote.aus.empty());
  const auto last = session_->finish(clock_.now());
  ASSERT_NE(last, nullptr);
}

TEST_F(WindowSessionTest, OnlyAnAddressThatAnsweredIsAmongTheRecentOnes) {
  options_.playback.endpoint = "lecture.example.org";
  open({frame({{26, Side::Both, 100}})});
  session_->begin_with(WindowSettings(options_, {}).in_force(), "", clock_.now());
  go_on(Milliseconds(0));
  EXPECT_TRUE(session_->recent().empty());
  source_->now.packets_received = 1;
  go_on(Milliseconds(0));
  EXPECT_EQ(session_->recent(), std::vector<std::string>{"lecture.example.org"});
  ask(gui::Connect{{"127.0.0.1", 1, 50, 20, 30, 0}});  // nothing listens there
  go_on(Milliseconds(100));
  EXPECT_EQ(session_->recent(), std::vector<std::string>{"lecture.example.org"});
}

TEST_F(WindowSessionTest, KeyframesWithTimesOfTheirOwnMakeTheSpeedUseless) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  EXPECT_TRUE(model().remote.timed);
}

TEST_F(WindowSessionTest, OtherRulesWhileConnectingLeaveNothingOfThoseBefore) {
  open({frame({{51, Side::Both, 100}, {52, Side::Both, 40}})});  // a rule fires
  go_on(Milliseconds(0));
  ASSERT_FALSE(model().remote.aus.empty());
  ask(gui::Connect{{"127.0.0.1", 1, 50, 20, 30, 0}});
  gui::AnimationSettings settings = model().animation;
  settings.rules = "none";
  ask(gui::ChangeAnimation{settings});
  EXPECT_EQ(model().animation.rules, "none");
  EXPECT_TRUE(model().remote.aus.empty());
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
