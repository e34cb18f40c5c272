#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "client/app/stream_files.h"
#include "client/gui/texts/texts.h"
#include "client/playback/seekable_playback.h"
#include "client/sound/wav_file.h"
#include "common/files.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"
#include "tests/unit/sound/cranked_out.h"

namespace aucast::app {
namespace {

using gui::Activity;
using gui::LocalCommand;

/// The default face and a stream file of three keyframes: jaw open, jaw shut, head turned.
class StreamSessionTest : public SessionOnDefaultFace {
 protected:
  void SetUp() override {
    file_ = folder_.write("three.txt", "Beg_Stream\n26;100\n0;200\n51;300\nEnd_Stream\n");
    session_.emplace(*assets_, options_, nullptr, stats_);
  }
  void open() {
    ask(gui::OpenStream{file_.string()});
    go_on(Milliseconds(0));
  }
  void ask(const gui::GuiCommand& command) {
    session_->apply(command, clock_.now());
    session_->advance(clock_.now());
  }

  test::TempFolder folder_;
  std::filesystem::path file_;
};

TEST_F(StreamSessionTest, TheTimesOfItsFacesAreWrittenUntilTheUserEndsIt) {
  open();
  ask(gui::Browse{gui::Purpose::LogOnsets});
  EXPECT_EQ(model().browser.name, "three_onsets.csv");
  ask(gui::EnterFolder{folder_.path().string()});
  ask(gui::ChooseFile{"times.csv"});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_EQ(model().onsets, (folder_.path() / "times.csv").string());
  session_->face_shown(Instant(std::chrono::seconds(5)), true);
  session_->face_shown(Instant(std::chrono::seconds(6)), false);
  go_on(Milliseconds(200));
  go_on(Milliseconds(10));
  session_->face_shown(Instant(std::chrono::seconds(7)), true);
  ask(gui::EndOnsets{});
  EXPECT_EQ(model().onsets, "");
  EXPECT_FALSE(model().notice.bad) << model().notice.text;
  EXPECT_EQ(folder_.read("times.csv"),
            "monotonic_s,keyframe,aus,reached\n5.000000,1,\"0\",\n7.000000,2,\"26:45\",1\n");
}

TEST_F(StreamSessionTest, AFilePlaysAsSoonAsItIsOpened) {
  open();
  EXPECT_TRUE(model().local.open);
  EXPECT_EQ(model().local.name, "three.txt");
  EXPECT_EQ(model().local.total, Milliseconds(600));
  EXPECT_EQ(model().playing.activity, Activity::Playing);
  EXPECT_EQ(model().playing.keyframe, "keyframe 1 of 3");
  go_on(Milliseconds(100));
  const float open_jaw = shown("jaw");
  EXPECT_GT(open_jaw, 0);
  go_on(Milliseconds(100));
  EXPECT_FLOAT_EQ(shown("jaw"), open_jaw / 2);
  EXPECT_FALSE(session_->playback().over());
  go_on(Milliseconds(1000));
  EXPECT_TRUE(session_->playback().over());
  EXPECT_EQ(model().playing.state, "ended");
  EXPECT_EQ(model().playing.aus[0].label, "51");
  EXPECT_GT(shown("head_turn_left"), 0.5F);
}

TEST_F(StreamSessionTest, AnyPlaceShowsTheFaceThatPlayingShowsThere) {
  open();
  go_on(Milliseconds(370));
  const std::vector<float> played = session_->face().activations(clock_.now());
  ask(LocalCommand(gui::Seek{Milliseconds(20)}));
  EXPECT_NE(session_->face().activations(clock_.now()), played);
  ask(LocalCommand(gui::Seek{Milliseconds(370)}));
  EXPECT_EQ(session_->face().activations(clock_.now()), played);
}

TEST_F(StreamSessionTest, KeysSeekByTimeAndToBothEnds) {
  open();
  session_->toggle_pause(clock_.now());
  const auto seek = [&](const LocalCommand& command) {
    ask(command);
    return model().local.position;
  };
  EXPECT_EQ(seek(gui::SeekBy{Milliseconds(250)}), Milliseconds(250));
  EXPECT_EQ(seek(gui::SeekBy{Milliseconds(-50)}), Milliseconds(200));
  EXPECT_EQ(seek(gui::SeekBy{Milliseconds(-5000)}), Milliseconds(0));
  EXPECT_EQ(seek(gui::Seek{Duration::max()}), Milliseconds(600));
  EXPECT_EQ(seek(gui::SeekBy{Milliseconds(5000)}), Milliseconds(600));
  EXPECT_EQ(seek(gui::Seek{Duration::zero()}), Milliseconds(0));
}

TEST_F(StreamSessionTest, AWholeFileIsRepeated) {
  open();
  ask(LocalCommand(gui::ToggleRepeat{}));
  EXPECT_TRUE(model().local.repeats);
  go_on(Milliseconds(6250));
  EXPECT_EQ(model().local.position, Milliseconds(250));
  EXPECT_FALSE(session_->playback().over());
  ask(LocalCommand(gui::ToggleRepeat{}));
  go_on(Milliseconds(6000));
  EXPECT_TRUE(session_->playback().over());
}

TEST_F(StreamSessionTest, RepeatingIsSaidWhereNoBarShowsIt) {
  open();
  ask(LocalCommand(gui::ToggleRepeat{}));
  EXPECT_EQ(model().notice.text, gui::tr("said.repeats"));
  ask(LocalCommand(gui::ToggleRepeat{}));
  EXPECT_EQ(model().notice.text, gui::tr("said.repeats_no_more"));
}

TEST_F(StreamSessionTest, SpaceHoldsAndPlaysAgainFromTheEnd) {
  open();
  go_on(Milliseconds(50));
  session_->toggle_pause(clock_.now());
  go_on(Milliseconds(5000));
  EXPECT_EQ(model().local.position, Milliseconds(50));
  EXPECT_EQ(model().playing.activity, Activity::Paused);
  session_->toggle_pause(clock_.now());
  go_on(Milliseconds(5000));
  EXPECT_TRUE(session_->playback().over());
  session_->toggle_pause(clock_.now());
  go_on(Milliseconds(10));
  EXPECT_EQ(model().local.position, Milliseconds(10));
}

TEST_F(StreamSessionTest, TheEditorBeginsWithTheFaceThatIsPlayed) {
  open();
  go_on(Milliseconds(50));
  ask(gui::Pause{});
  const float open_jaw = shown("jaw");
  ASSERT_GT(open_jaw, 0);
  const auto channel = static_cast<int>(*assets_->face.channel_index("left_zygomaticus_major"));
  const auto jaw_of_panel = [this, jaw = static_cast<int>(*assets_->face.channel_index("jaw"))] {
    const gui::EditorView view = model().editor;
    for (const auto& group : view.groups) {
      for (const auto& row : group.rows) {
        if (row.left == jaw) return row.left_value;
      }
    }
    return 0.0F;
  };
  EXPECT_FLOAT_EQ(jaw_of_panel(), open_jaw) << "what is moved is what is seen";
  ask(gui::SetChannel{channel, 0.5F, false});
  EXPECT_TRUE(model().editor.active);
  EXPECT_FLOAT_EQ(shown("jaw"), open_jaw);
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), 0.5F);
  ask(gui::Undo{});
  EXPECT_FLOAT_EQ(shown("jaw"), open_jaw);
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), 0);
  // What is not saved is not thrown away for the face that plays.
  ask(gui::SetChannel{channel, 0.25F, false});
  ask(LocalCommand(gui::Seek{Milliseconds(300)}));
  EXPECT_FALSE(model().editor.active);
  ask(gui::SetChannel{channel, 0.75F, false});
  EXPECT_FLOAT_EQ(shown("jaw"), open_jaw);
}

TEST_F(StreamSessionTest, ASoundIsHeardWithWhatPlays) {
  const auto sound = folder_.write("voice.wav", "");
  ask(gui::OpenStream{sound.string()});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_EQ(model().notice.text, gui::tr("said.sound_alone", "voice.wav"));
  open();
  ask(gui::OpenStream{sound.string()});
  EXPECT_EQ(model().notice.text, gui::tr("said.not_heard", "voice.wav"));
  sound::test::Crank crank;
  session_->set_sound(std::make_unique<sound::test::CrankedOut>(crank), clock_.now());
  ask(gui::OpenStream{sound.string()});
  EXPECT_NE(model().notice.text.find("voice.wav"), std::string::npos) << "it is empty";
  EXPECT_TRUE(model().notice.bad);
  auto wav = sound::WavFile::open(sound);
  ASSERT_TRUE(wav) << wav.error().message;
  (*wav)->add(std::vector<float>(48'000, 0.5F));
  ASSERT_TRUE((*wav)->finish());
  ask(gui::OpenStream{sound.string()});
  EXPECT_EQ(model().notice.text, gui::tr("said.sound_plays", "voice.wav", "three.txt"));
  ask(gui::Resume{});
  for (int i = 0; i < 10; ++i) {
    go_on(Milliseconds(20));
    crank.turn(Milliseconds(20));
  }
  EXPECT_TRUE(std::any_of(crank.written.begin(), crank.written.end(),
                          [](float sample) { return sample > 0.25F; }));
}

TEST_F(StreamSessionTest, AStepTakesTheFaceBackFromTheEditor) {
  open();
  ask(gui::SetChannel{static_cast<int>(*assets_->face.channel_index("jaw")), 4, false});
  EXPECT_TRUE(model().editor.active);
  EXPECT_FALSE(model().local.playing);
  ask(LocalCommand(gui::StepKeyframe{1}));
  EXPECT_FALSE(model().editor.active);
  EXPECT_EQ(model().local.position, Milliseconds(100));
  EXPECT_LT(shown("jaw"), 4);
}

TEST_F(StreamSessionTest, RepeatAfterTheEndTakesTheFaceBackFromTheEditor) {
  open();
  go_on(Milliseconds(600));
  ASSERT_TRUE(session_->playback().over());
  ask(gui::ShowAus{"12"});
  EXPECT_TRUE(model().editor.active);
  ask(LocalCommand(gui::ToggleRepeat{}));
  EXPECT_FALSE(model().editor.active);
  EXPECT_EQ(model().playing.activity, Activity::Playing);
  go_on(Milliseconds(100));
  EXPECT_EQ(session_->face().keyframe(), 1U);
}

TEST_F(StreamSessionTest, TheTableOfAusIsOfTheFaceThatIsShown) {
  open();
  session_->toggle_pause(clock_.now());
  ask(LocalCommand(gui::StepKeyframe{1}));
  EXPECT_EQ(model().playing.keyframe, "keyframe 1 of 3");
  ASSERT_EQ(model().playing.aus.size(), 1U);
  EXPECT_EQ(model().playing.aus[0].label, "26");
  EXPECT_EQ(model().playing.aus[0].shown_percent, 100);
  ask(LocalCommand(gui::Seek{Milliseconds(200)}));
  ASSERT_EQ(model().playing.aus.size(), 1U) << "on the way to neutral";
  EXPECT_EQ(model().playing.aus[0].received_percent, 0);
  EXPECT_EQ(model().playing.aus[0].shown_percent, 50);
  ask(LocalCommand(gui::StepKeyframe{1}));
  EXPECT_TRUE(model().playing.aus.empty());
}

TEST_F(StreamSessionTest, OtherRulesAreSeenWhereItStands) {
  const auto file = folder_.write("opposed.txt", "Beg_Stream\n51,52:40;100\nEnd_Stream\n");
  ask(gui::OpenStream{file.string()});
  go_on(Milliseconds(1000));
  EXPECT_EQ(shown("head_turn_right"), 0);
  gui::AnimationSettings settings = model().animation;
  settings.rules = "none";
  ask(gui::ChangeAnimation{settings});
  EXPECT_FLOAT_EQ(shown("head_turn_right"), 0.4F);
}

TEST_F(StreamSessionTest, AFileThatIsNoStreamIsSaidWithItsPlace) {
  open();
  const auto wrong = folder_.write("wrong.txt", "Beg_Stream\n1,200\nEnd_Stream\n");
  ask(gui::OpenStream{wrong.string()});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("wrong.txt:2:"), std::string::npos) << model().notice.text;
  EXPECT_EQ(model().local.name, "three.txt") << "what plays stays";
  const auto right = folder_.write("right.txt", "Beg_Stream\n1\nEnd_Stream\n");
  ask(gui::OpenStream{right.string()});
  EXPECT_TRUE(model().notice.text.empty()) << "it was about another file";
  ask(gui::OpenStream{wrong.string()});
  go_on(std::chrono::seconds(60));
  EXPECT_TRUE(model().notice.text.empty());
}

TEST_F(StreamSessionTest, ATableOfARecogniserPlaysAsItIsSetToBeRead) {
  std::string text = "frame, face_id, timestamp, confidence, success, AU12_r, AU12_c\n";
  for (int i = 0; i < 10; ++i) {
    text += std::to_string(i + 1) + ", 0, " + std::to_string(0.1 * i) + ", 0.98, 1, " +
            (i < 5 ? "1.0" : "2.5") + ", 1\n";
  }
  const auto table = folder_.write("talk.csv", text);
  ask(gui::OpenStream{table.string()});
  EXPECT_NE(model().notice.text.find("10 rows"), std::string::npos) << model().notice.text;
  ASSERT_TRUE(model().local.open);
  EXPECT_EQ(model().local.ends->size(), 10U);
  ask(LocalCommand(gui::Seek{Duration::max()}));
  ASSERT_EQ(model().playing.aus.size(), 1U);
  EXPECT_EQ(model().playing.aus[0].shown_percent, 50);
  ask(gui::Browse{gui::Purpose::PlayStream});
  ask(gui::EnterFolder{folder_.path().string()});
  ask(gui::ChangeTable{{.fps = 0, .rate = 0, .gain_percent = 150, .neutral_s = 0}});
  ask(gui::ChooseFile{"talk.csv"});
  EXPECT_NE(model().notice.text.find("gain 150 %"), std::string::npos) << model().notice.text;
  ask(LocalCommand(gui::Seek{Duration::max()}));
  ASSERT_EQ(model().playing.aus.size(), 1U);
  EXPECT_EQ(model().playing.aus[0].shown_percent, 75);
  // The next file is read as it is, this one as it was, also by its name alone.
  const auto another = folder_.write("another.csv", text);
  ask(gui::Browse{gui::Purpose::PlayStream});
  ask(gui::ChooseFile{"another.csv"});
  ask(LocalCommand(gui::Seek{Duration::max()}));
  EXPECT_EQ(model().playing.aus.at(0).shown_percent, 50);
  EXPECT_EQ(session_->kept().tables.size(), 1U);
  ask(gui::OpenStream{table.string()});
  ask(LocalCommand(gui::Seek{Duration::max()}));
  EXPECT_EQ(model().playing.aus.at(0).shown_percent, 75);
  EXPECT_EQ(model().recent_files, (std::vector<std::string>{table.string(), another.string()}));
}

TEST_F(StreamSessionTest, WhatIsOddInATableIsAWarning) {
  std::string text = "frame, face_id, timestamp, confidence, success, AU12_r, AU12_c\n";
  for (int i = 0; i < 20; ++i) {
    text += std::to_string(i + 1) + ", 0, " + std::to_string(0.1 * i) + ", 0.98, 1, 5.0, 1\n";
  }
  folder_.write("loud.csv", text);
  ask(gui::Browse{gui::Purpose::PlayStream});
  ask(gui::EnterFolder{folder_.path().string()});
  ask(gui::ChangeTable{{.fps = 0, .rate = 0, .gain_percent = 0, .neutral_s = 1}});
  ask(gui::ChooseFile{"loud.csv"});
  ASSERT_TRUE(model().local.open);
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("AU12 100 %: no neutral face"), std::string::npos)
      << model().notice.text;
}

TEST_F(StreamSessionTest, TheDialogOpensAFileAndKeepsOpenForOneThatIsWrong) {
  folder_.write("wrong.txt", "");
  ask(gui::Browse{gui::Purpose::PlayStream});
  EXPECT_TRUE(model().browser.open);
  ask(gui::EnterFolder{folder_.path().string()});
  ask(gui::ChooseFile{"wrong.txt"});
  EXPECT_TRUE(model().browser.open);
  EXPECT_NE(model().browser.problem.find("wrong.txt:1:"), std::string::npos);
  EXPECT_FALSE(model().local.open);
  ask(gui::ChooseFile{"three.txt"});
  EXPECT_FALSE(model().browser.open);
  EXPECT_TRUE(model().local.open);
}

TEST_F(StreamSessionTest, AFilmIsToldToBeOne) {
  ask(gui::OpenStream{folder_.write("me.mp4", std::string(9, '\0')).string()});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("me.mp4 is a film"), std::string::npos);
}

TEST_F(StreamSessionTest, TheDialogComesAgainInTheFolderThatItHasShown) {
  ask(gui::Browse{gui::Purpose::PlayStream});
  ask(gui::EnterFolder{folder_.path().string()});
  ask(gui::CloseBrowser{});
  ask(gui::Browse{gui::Purpose::PlayStream});
  EXPECT_EQ(model().browser.folder, folder_.path().string());
}

TEST_F(StreamSessionTest, TheFileOfTheCommandLineEndsWithItsStatistics) {
  auto stream = read_stream(file_);
  ASSERT_TRUE(stream);
  options_.playback.file = file_;
  session_.emplace(
      *assets_, options_,
      std::make_unique<playback::SeekablePlayback>(stream->keyframes, Milliseconds(250)), stats_);
  go_on(Milliseconds(0));
  EXPECT_EQ(model().local.name, "three.txt");
  go_on(Milliseconds(600));
  const auto last = session_->finish(clock_.now());
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->status().end, playback::EndReason::EndOfStream);
  EXPECT_EQ(stats_.keyframes_played, 3U);
  EXPECT_DOUBLE_EQ(stats_.media_seconds, 0.6);
}

TEST_F(StreamSessionTest, WhatIsPlayedIsExported) {
  open();
  ask(gui::Browse{gui::Purpose::ExportKeyframes});
  EXPECT_EQ(model().browser.name, "three_played.txt") << "after the stream";
  const auto file = folder_.path() / "copy.txt";
  ask(gui::ChooseFile{file.string()});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_NE(model().notice.text.find("3 keyframes saved in " + file.string()), std::string::npos);
  EXPECT_EQ(*read_file(file), "Beg_Stream\n26;100\n0;200\n51;300\nEnd_Stream\n");
}

TEST_F(StreamSessionTest, NothingPlayedIsNothingToExport) {
  ask(gui::Browse{gui::Purpose::ExportKeyframes});
  ask(gui::ChooseFile{(folder_.path() / "copy.txt").string()});
  EXPECT_TRUE(model().browser.open);
  EXPECT_FALSE(model().browser.problem.empty());
}

TEST_F(StreamSessionTest, LeavingBeforeTheEndIsAStop) {
  open();
  go_on(Milliseconds(150));
  const auto last = session_->finish(clock_.now());
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->status().end, playback::EndReason::Stopped);
  EXPECT_EQ(stats_.keyframes_played, 1U);
}

}  // namespace
}  // namespace aucast::app
