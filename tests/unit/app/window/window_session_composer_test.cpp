#include <gtest/gtest.h>

#include "common/files.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"

namespace aucast::app {
namespace {

using gui::ComposerCommand;

/// The composer on the default face.
class WindowSessionComposerTest : public SessionOnDefaultFace {
 protected:
  void SetUp() override { session_.emplace(*assets_, options_, nullptr, stats_); }
  void compose(const ComposerCommand& command) { ask(command); }
  void ask(const gui::GuiCommand& command) {
    session_->apply(command, clock_.now());
    session_->advance(clock_.now());
  }
  /// Two keyframes: jaw open, then shut.
  void make_two() {
    compose(gui::ComposeAu{26, 100, 100, false});
    compose(gui::AddKeyframe{});
    compose(gui::ComposeNeutral{});
    compose(gui::AddKeyframe{});
  }
};

TEST_F(WindowSessionComposerTest, TheEditorBeginsWithTheFaceThatIsComposed) {
  compose(gui::ComposeAu{26, 100, 100, false});
  const float jaw = shown("jaw");
  ASSERT_GT(jaw, 0);
  ask(gui::SetChannel{static_cast<int>(*assets_->face.channel_index("head_turn_left")), 0.5F,
                      false});
  EXPECT_TRUE(model().editor.active);
  EXPECT_FLOAT_EQ(shown("jaw"), jaw);
}

TEST_F(WindowSessionComposerTest, TheFaceShowsWhatIsComposedWithTheRules) {
  compose(gui::ComposeAu{51, 100, 100, false});
  compose(gui::ComposeAu{52, 40, 40, false});
  EXPECT_TRUE(model().composer.active);
  EXPECT_FLOAT_EQ(shown("head_turn_left"), 0.6F);
  gui::AnimationSettings settings = model().animation;
  settings.rules = "none";
  ask(gui::ChangeAnimation{settings});
  EXPECT_FLOAT_EQ(shown("head_turn_left"), 1.0F);
  ASSERT_EQ(model().composer.aus.size(), 2U);
  EXPECT_EQ(model().composer.aus[1].name, "Head Turn Right");
}

TEST_F(WindowSessionComposerTest, WhatIsComposedIsPlayed) {
  make_two();
  EXPECT_EQ(model().composer.total, "2 keyframes, 1.00 s");
  ASSERT_EQ(model().composer.rows->size(), 2U);
  EXPECT_EQ((*model().composer.rows)[0].aus, "26");
  compose(gui::PlayComposition{});
  EXPECT_FALSE(model().composer.active);
  EXPECT_EQ(model().local.total, Milliseconds(1000));
  go_on(Milliseconds(500));
  EXPECT_GT(shown("jaw"), 1);
  go_on(Milliseconds(600));
  EXPECT_EQ(shown("jaw"), 0);
}

TEST_F(WindowSessionComposerTest, AKeyframeThatWasBegunWaitsWhileSomethingElsePlays) {
  make_two();
  compose(gui::PlayComposition{});
  EXPECT_EQ(model().notice.text, "") << "all of it is played";
  compose(gui::ComposeAu{26, 40, 40, false});
  EXPECT_FALSE(model().composer.aside);
  const float jaw = shown("jaw");
  compose(gui::PlayComposition{});
  EXPECT_NE(model().notice.text, "") << "the new keyframe is not played";
  EXPECT_TRUE(model().composer.aside);
  EXPECT_TRUE(model().composer.unsaved);
  go_on(Milliseconds(100));
  compose(gui::ShowComposed{});
  EXPECT_TRUE(model().composer.active);
  EXPECT_FALSE(model().composer.aside);
  EXPECT_FLOAT_EQ(shown("jaw"), jaw);
  EXPECT_EQ(model().playing.activity, gui::Activity::Paused);
}

TEST_F(WindowSessionComposerTest, ThePadBlendsThePrototypesOfTheData) {
  ASSERT_GE(model().composer.pad->size(), 6U);
  for (const gui::PadPoint& point : *model().composer.pad) {
    compose(gui::ComposeMood{point.x, point.y, false});
    std::vector<AuTerm> composed;
    for (const gui::ComposedAu& au : model().composer.aus) {
      composed.push_back({static_cast<std::uint8_t>(au.number), Side::Both,
                          static_cast<std::uint8_t>(au.left_percent)});
    }
    EXPECT_EQ(composed, canonical_terms(point.aus)) << point.label;
  }
}

TEST_F(WindowSessionComposerTest, SavedFromTheDialogAndLoadedAgain) {
  const test::TempFolder folder;
  make_two();
  EXPECT_TRUE(model().composer.unsaved);
  compose(gui::SaveComposition{});
  ASSERT_TRUE(model().browser.open) << "it has no file yet";
  EXPECT_EQ(model().browser.name, "composed.txt");
  ask(gui::EnterFolder{folder.path().string()});
  ask(gui::ChooseFile{"mine.txt"});
  EXPECT_FALSE(model().browser.open);
  EXPECT_FALSE(model().composer.unsaved);
  const auto file = folder.path() / "mine.txt";
  EXPECT_NE(model().notice.text.find(file.string()), std::string::npos);
  EXPECT_EQ(*read_file(file), "Beg_Stream\n26;500\n0;500\nEnd_Stream\n");

  compose(gui::NewComposition{});
  EXPECT_TRUE(model().composer.rows->empty());
  ask(gui::Browse{gui::Purpose::ComposeStream});
  ask(gui::ChooseFile{file.string()});
  EXPECT_EQ(model().composer.rows->size(), 2U);
  EXPECT_EQ(model().composer.file, file.string());
  compose(gui::ComposeTime{std::nullopt, false});
  compose(gui::SaveComposition{});
  EXPECT_FALSE(model().browser.open) << "it has a file";
  EXPECT_EQ(*read_file(file), "Beg_Stream\n26\n0;500\nEnd_Stream\n");
}

TEST_F(WindowSessionComposerTest, AnExistingFileIsAskedAbout) {
  const test::TempFolder folder;
  const auto file = folder.write("mine.txt", "not mine");
  make_two();
  ask(gui::Browse{gui::Purpose::SaveStream});
  ask(gui::ChooseFile{file.string()});
  EXPECT_EQ(model().browser.replaces, file.string());
  EXPECT_EQ(*read_file(file), "not mine");
  ask(gui::ChooseFile{file.string()});
  EXPECT_FALSE(model().browser.open);
  EXPECT_NE(*read_file(file), "not mine");
  ASSERT_FALSE(model().recent_files.empty());
  EXPECT_EQ(model().recent_files.front(), file.string());
}

TEST_F(WindowSessionComposerTest, APlaceThatCannotBeWrittenIsSaidAndNothingIsLost) {
  make_two();
  ask(gui::Browse{gui::Purpose::SaveStream});
  ask(gui::ChooseFile{"/proc/no-such-file.txt"});
  EXPECT_TRUE(model().browser.open);
  EXPECT_FALSE(model().browser.problem.empty());
  EXPECT_TRUE(model().composer.unsaved);
}

TEST_F(WindowSessionComposerTest, WhatIsAddedIsTheFaceThatIsSeen) {
  ask(gui::ShowAus{"6,12:60"});
  compose(gui::AddKeyframe{});
  ask(gui::ShowAus{"4"});
  compose(gui::ChooseKeyframe{0});
  EXPECT_EQ(model().composer.rows->size(), 1U);
  ASSERT_EQ(model().composer.aus.size(), 2U) << "it is not the neutral face";
  EXPECT_EQ(model().composer.aus[1].left_percent, 60);
  ask(gui::ShowAus{"4"});
  compose(gui::AddKeyframe{});
  EXPECT_EQ(model().composer.aus.size(), 2U) << "of a chosen keyframe it is a copy";
}

TEST_F(WindowSessionComposerTest, WhatWasBegunIsShownBeforeItIsAdded) {
  compose(gui::ComposeAu{26, 100, 100, false});
  ask(gui::ShowAus{"6,12"});
  ASSERT_FALSE(model().composer.active);
  compose(gui::AddKeyframe{});
  EXPECT_TRUE(model().composer.rows->empty()) << "another face was seen";
  EXPECT_TRUE(model().composer.active);
  EXPECT_EQ(model().notice.text, gui::tr("said.composed_face"));
  compose(gui::AddKeyframe{});
  ASSERT_EQ(model().composer.rows->size(), 1U);
  EXPECT_EQ(model().composer.rows->front().aus, "26");
}

TEST_F(WindowSessionComposerTest, ANewStreamSaysHowWhatIsNotSavedComesBack) {
  compose(gui::NewComposition{});
  EXPECT_TRUE(model().notice.text.empty()) << "there was nothing";
  make_two();
  compose(gui::NewComposition{});
  EXPECT_EQ(model().notice.text, "a new stream: Undo brings back the keyframes that are not saved");
  compose(gui::UndoComposing{});
  EXPECT_EQ(model().composer.rows->size(), 2U);
}

TEST_F(WindowSessionComposerTest, AnOpenedStreamSaysHowWhatIsNotSavedComesBack) {
  const test::TempFolder folder;
  const std::string file = folder.write("one.txt", "Beg_Stream\n12;500\nEnd_Stream\n").string();
  for (const bool unsaved : {false, true}) {
    if (unsaved) make_two();
    ask(gui::Browse{gui::Purpose::ComposeStream});
    ask(gui::ChooseFile{file});
    EXPECT_EQ(model().composer.rows->size(), 1U);
    EXPECT_EQ(model().notice.text, unsaved ? gui::tr("said.other_stream") : "");
  }
  compose(gui::UndoComposing{});
  EXPECT_TRUE(model().composer.unsaved);
}

TEST_F(WindowSessionComposerTest, LeavingAsksAboutAKeyframeThatWasNotAdded) {
  const test::TempFolder folder;
  compose(gui::ComposeAu{12, 50, 50, false});
  EXPECT_FALSE(model().composer.unsaved) << "nothing can be saved";
  EXPECT_TRUE(model().composer.begun);
  session_->ask_to_leave();
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().asks_to_leave);
  ask(gui::Leave{false});
  EXPECT_FALSE(session_->leaving().leaves());
  compose(gui::AddKeyframe{});
  EXPECT_TRUE(model().composer.unsaved);
  EXPECT_FALSE(model().composer.begun);
  ask(gui::Browse{gui::Purpose::SaveStream});
  ask(gui::ChooseFile{(folder.path() / "mine.txt").string()});
  compose(gui::ComposeAu{12, 70, 70, false});
  compose(gui::AddKeyframe{});
  compose(gui::ComposeAu{26, 70, 70, false});
  session_->ask_to_leave();
  ask(gui::Leave{.really = false, .saves = true});
  EXPECT_FALSE(model().composer.unsaved);
  EXPECT_TRUE(model().asks_to_leave) << "saving did not add it";
  EXPECT_FALSE(session_->leaving().leaves());
}

TEST_F(WindowSessionComposerTest, SavingOnLeavingLeavesOnceTheNewFileHasItsName) {
  const test::TempFolder folder;
  make_two();
  session_->ask_to_leave();
  ask(gui::Leave{.really = false, .saves = true});
  ASSERT_TRUE(model().browser.open);
  ask(gui::ChooseFile{"/proc/no-such-file.txt"});
  EXPECT_FALSE(session_->leaving().leaves()) << "it is not saved yet";
  ask(gui::ChooseFile{(folder.path() / "mine.txt").string()});
  EXPECT_FALSE(model().composer.unsaved);
  EXPECT_TRUE(session_->leaving().leaves());
}

TEST_F(WindowSessionComposerTest, WhoCancelsTheSavingOnLeavingStays) {
  const test::TempFolder folder;
  make_two();
  session_->ask_to_leave();
  ask(gui::Leave{.really = false, .saves = true});
  ask(gui::CloseBrowser{});
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_FALSE(model().asks_to_leave);
  ask(gui::Browse{gui::Purpose::SaveStream});
  ask(gui::ChooseFile{(folder.path() / "mine.txt").string()});
  EXPECT_FALSE(session_->leaving().leaves()) << "that was saved for its own sake";
}

TEST_F(WindowSessionComposerTest, LeavingAsksWhenTheStreamIsNotSaved) {
  compose(gui::ComposeAu{12, 50, 50, false});
  compose(gui::AddKeyframe{});
  session_->ask_to_leave();
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().asks_to_leave);
  ask(gui::Leave{false});
  compose(gui::UndoComposing{});
  compose(gui::UndoComposing{});
  session_->ask_to_leave();
  EXPECT_TRUE(session_->leaving().leaves());
}

/// A gallery for which no picture is drawn. It is seen to have ended in advance() only.
gui::GallerySettings quick_gallery(const std::filesystem::path& folder) {
  gui::GallerySettings settings;
  settings.folder = folder.string();
  settings.sections = {};
  settings.sections[5] = true;  // which AUs there are
  return settings;
}

TEST_F(WindowSessionComposerTest, LeavingAsksWhileAGalleryIsBeingMade) {
  const test::TempFolder folder;
  ask(gui::GalleryCommand(gui::ChangeGallery{quick_gallery(folder.path() / "gallery")}));
  session_->apply(gui::GalleryCommand(gui::BeginGallery{}), clock_.now());
  ASSERT_TRUE(model().gallery.running);
  session_->ask_to_leave();
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().asks_to_leave);
  while (model().gallery.running) session_->advance(clock_.now());
  EXPECT_FALSE(model().asks_to_leave) << "there is nothing left to lose";
  EXPECT_FALSE(session_->leaving().leaves()) << "how it ended is to be read";
  session_->ask_to_leave();
  EXPECT_TRUE(session_->leaving().leaves());
}

TEST_F(WindowSessionComposerTest, HowAGalleryEndedIsSaidWhereItsDialogIsClosed) {
  const test::TempFolder folder;
  ask(gui::GalleryCommand(gui::ChangeGallery{quick_gallery(folder.path() / "gallery")}));
  for (const bool open : {true, false}) {
    if (open) session_->apply(gui::GalleryCommand(gui::OpenGallery{}), clock_.now());
    session_->apply(gui::GalleryCommand(gui::BeginGallery{}), clock_.now());
    if (!open) session_->apply(gui::GalleryCommand(gui::CloseGallery{}), clock_.now());
    while (model().gallery.running) session_->advance(clock_.now());
    EXPECT_FALSE(model().gallery.outcome.empty());
    EXPECT_EQ(model().notice.text, open ? "" : model().gallery.outcome);
  }
}

TEST_F(WindowSessionComposerTest, SavingOnLeavingStillAsksAboutTheGallery) {
  const test::TempFolder folder;
  make_two();
  ask(gui::Browse{gui::Purpose::SaveStream});
  ask(gui::ChooseFile{(folder.path() / "mine.txt").string()});
  compose(gui::AddKeyframe{});
  ask(gui::GalleryCommand(gui::ChangeGallery{quick_gallery(folder.path() / "gallery")}));
  session_->apply(gui::GalleryCommand(gui::BeginGallery{}), clock_.now());
  session_->ask_to_leave();
  session_->apply(gui::Leave{.really = false, .saves = true}, clock_.now());
  EXPECT_FALSE(model().composer.unsaved);
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().asks_to_leave);
  ask(gui::Leave{true});
  EXPECT_TRUE(session_->leaving().leaves());
}

}  // namespace
}  // namespace aucast::app
