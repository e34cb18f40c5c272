#include "client/app/window/making/composer_session.h"

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "client/gui/texts/texts.h"
#include "common/files.h"
#include "protocol/codec.h"
#include "tests/support/manual_clock.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::app {
namespace {

using Next = ComposerSession::Next;

/// On the small face, with two expressions on the pad.
class ComposerSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    assets_.face = face::test::small_face();
    assets_.expressions.push_back({"joy", "Joy", set("12:80"), {}, "", {{0.8F, 0.5F}}});
    assets_.expressions.push_back({"calm", "Calm", set("43:20"), {}, "", {{0.6F, -0.8F}}});
    assets_.expressions.push_back({"yawn", "Yawn", set("26"), {}, "", {}});
    mapping_.emplace(pipeline::AuMapping{assets_.face, assets_.face.recordings, {}});
    composer_.emplace(assets_, *mapping_, notices_);
  }

  static AuFrame set(const char* text) { return *protocol::parse_au_set(text); }
  /// While the composer's face is shown.
  Next ask(const gui::ComposerCommand& command) { return ask_beside(command, true, std::nullopt); }
  /// While a face of these AUs is shown.
  Next ask_beside(const gui::ComposerCommand& command, const char* aus) {
    return ask_beside(command, false, set(aus));
  }
  Next ask_beside(const gui::ComposerCommand& command, bool active,
                  const std::optional<AuFrame>& seen) {
    return composer_->apply(command, active, seen, clock_.now());
  }
  [[nodiscard]] float jaw() const {
    return composer_->activations()[*assets_.face.channel_index("jaw")];
  }

  Assets assets_;
  std::optional<pipeline::AuMapping> mapping_;
  Notices notices_;
  test::ManualClock clock_;
  std::optional<ComposerSession> composer_;
};

TEST_F(ComposerSessionTest, BeginsWithTheNeutralFaceAndNoKeyframe) {
  const gui::ComposerView view = composer_->view(true);
  EXPECT_TRUE(view.rows->empty());
  EXPECT_EQ(view.total, gui::tr("said.no_keyframes"));
  EXPECT_TRUE(view.aus.empty());
  EXPECT_EQ(jaw(), 0);
  EXPECT_FALSE(composer_->unsaved());
}

TEST_F(ComposerSessionTest, RowsAreMadeAnewOnlyWhenKeyframesChange) {
  ask(gui::ComposeAu{26, 100, 100, false});
  ask(gui::AddKeyframe{});
  ask(gui::AddKeyframe{});
  const auto rows = composer_->view(true).rows;
  ask(gui::ChooseKeyframe{0});
  EXPECT_EQ(composer_->view(true).rows, rows);
  ask(gui::ComposeAu{12, 50, 50, false});
  EXPECT_EQ(composer_->view(true).rows->at(0).aus, "12:50,26");
  EXPECT_EQ(composer_->view(true).rows->at(1), rows->at(1));
}

TEST_F(ComposerSessionTest, AnAuIsShownAndListedWhenItsKeyframeIsAdded) {
  EXPECT_EQ(ask(gui::ComposeAu{26, 100, 100, false}), Next::Show);
  EXPECT_GT(jaw(), 0);
  ASSERT_EQ(composer_->view(true).aus.size(), 1U);
  EXPECT_EQ(composer_->view(true).aus[0].name, "Jaw Drop");
  EXPECT_TRUE(composer_->view(true).rows->empty());
  EXPECT_EQ(ask(gui::AddKeyframe{}), Next::Show);
  ASSERT_EQ(composer_->view(true).rows->size(), 1U);
  EXPECT_EQ(composer_->view(true).rows->front(), (gui::TimelineRow{"26", "500 ms"}));
  EXPECT_EQ(composer_->view(true).total, "1 keyframe, 0.50 s");
}

TEST_F(ComposerSessionTest, AnAuOfTheUsersOwnHasItsName) {
  face::AuRecording puffy = mapping_->recordings.at(26);
  puffy.number = 90;
  puffy.note = "Puffy cheeks";
  mapping_->recordings[90] = puffy;
  ask(gui::ComposeAu{90, 100, 100, false});
  ASSERT_EQ(composer_->view(true).aus.size(), 1U);
  EXPECT_EQ(composer_->view(true).aus[0].name, "Puffy cheeks");
}

TEST_F(ComposerSessionTest, ATimeChangesNoFace) {
  ask(gui::ComposeMood{0.8F, 0.5F, false});
  EXPECT_EQ(ask(gui::ComposeTime{std::nullopt, false}), Next::Nothing);
  EXPECT_EQ(composer_->view(true).ms, std::nullopt);
  EXPECT_TRUE(composer_->view(true).pad_at.has_value()) << "the pad is where it was";
  ask(gui::AddKeyframe{});
  EXPECT_EQ(composer_->view(true).rows->front().time, gui::tr("said.no_time"));
  EXPECT_EQ(composer_->view(true).total, "1 keyframe, 0.25 s") << "as a player plays it";
}

TEST_F(ComposerSessionTest, ThePadHasTheExpressionsThatHaveAPlaceOnIt) {
  ASSERT_EQ(composer_->view(true).pad->size(), 2U);
  EXPECT_EQ(ask(gui::ComposeMood{0.8F, 0.5F, false}), Next::Show);
  EXPECT_EQ(protocol::format_au_set(composer_->aus()), "12:80");
  ask(gui::ComposeAu{26, 50, 50, false});
  EXPECT_EQ(composer_->view(true).pad_at, std::nullopt) << "the face is no longer of the pad";
}

TEST_F(ComposerSessionTest, WhatIsToBePlayedOrSavedIsLeftToTheWindow) {
  EXPECT_EQ(ask(gui::PlayComposition{}), Next::Nothing) << "there is no keyframe";
  ask(gui::ComposeAu{26, 100, 100, false});
  ask(gui::AddKeyframe{});
  EXPECT_EQ(ask(gui::PlayComposition{}), Next::Play);
  EXPECT_EQ(ask(gui::SaveComposition{}), Next::Save);
  EXPECT_EQ(composer_->keyframes().size(), 1U);
}

TEST_F(ComposerSessionTest, TakesAFaceAsOneStep) {
  EXPECT_EQ(ask_beside(gui::ComposeShown{}, "12:40,26"), Next::Show);
  EXPECT_EQ(protocol::format_au_set(composer_->aus()), "12:40,26");
  EXPECT_GT(jaw(), 0);
  EXPECT_EQ(ask(gui::UndoComposing{}), Next::Show);
  EXPECT_EQ(jaw(), 0);
  EXPECT_FALSE(composer_->view(true).can_undo);
  ask(gui::RedoComposing{});
  EXPECT_GT(jaw(), 0);
}

TEST_F(ComposerSessionTest, AFaceOfMusclesIsNotTaken) {
  EXPECT_EQ(ask_beside(gui::ComposeShown{}, false, std::nullopt), Next::Nothing);
  EXPECT_FALSE(composer_->composes());
}

TEST_F(ComposerSessionTest, WhatIsTakenIsInTheTimelineAtOnce) {
  ask(gui::ComposeAu{26, 100, 100, false});
  ask(gui::AddKeyframe{});
  ask(gui::ChooseKeyframe{0});
  ask_beside(gui::ComposeShown{}, "12:40");
  ASSERT_EQ(composer_->view(true).rows->size(), 1U);
  EXPECT_EQ(composer_->view(true).rows->front(), (gui::TimelineRow{"12:40", "500 ms"}));
}

TEST_F(ComposerSessionTest, WhatIsAddedWasSeen) {
  EXPECT_EQ(ask_beside(gui::AddKeyframe{}, "12:40"), Next::Show);
  EXPECT_EQ(composer_->view(true).rows->front().aus, "12:40");
  ask(gui::ComposeAu{26, 100, 100, false});
  EXPECT_EQ(ask_beside(gui::AddKeyframe{}, "12:40"), Next::Show);
  EXPECT_EQ(composer_->view(true).rows->size(), 1U) << "it is shown first";
  EXPECT_EQ(notices_.view().text, gui::tr("said.composed_face"));
}

TEST_F(ComposerSessionTest, IsRemadeForAnotherFace) {
  ask(gui::ComposeAu{26, 100, 100, false});
  const float before = jaw();
  mapping_->recordings.at(26).activation[*assets_.face.channel_index("jaw")] = before / 2;
  composer_->remake();
  EXPECT_FLOAT_EQ(jaw(), before / 2);
}

TEST_F(ComposerSessionTest, IsSavedAndLoadedWithTimesAndWithout) {
  const test::TempFolder folder;
  ask(gui::ComposeAu{26, 100, 50, false});
  ask(gui::AddKeyframe{});
  ask(gui::ComposeNeutral{});
  ask(gui::ComposeTime{std::nullopt, false});
  ask(gui::AddKeyframe{});
  const auto file = folder.path() / "mine.txt";
  const auto saved = composer_->save(file);
  ASSERT_TRUE(saved.has_value()) << saved.error().message;
  EXPECT_NE(saved->find(file.string()), std::string::npos);
  EXPECT_FALSE(composer_->unsaved());
  ask(gui::NewComposition{});
  EXPECT_TRUE(composer_->keyframes().empty());
  ASSERT_TRUE(composer_->load(file).has_value());
  EXPECT_EQ(composer_->file(), file);
  const auto keyframes = composer_->keyframes();
  ASSERT_EQ(keyframes.size(), 2U);
  EXPECT_EQ(keyframes[0].aus, set("L26,R26:50"));
  EXPECT_EQ(keyframes[0].time, Milliseconds(500));
  EXPECT_EQ(keyframes[1].time, std::nullopt);
}

TEST_F(ComposerSessionTest, AStreamKeepsItsTitle) {
  const test::TempFolder folder;
  const auto file =
      folder.write("titled.txt", "Beg_Stream\n# Title:  A talk \n26;500\nEnd_Stream\n");
  ASSERT_TRUE(composer_->load(file));
  ask(gui::ComposeAu{26, 50, 50, false});
  ASSERT_TRUE(composer_->save(file));
  EXPECT_EQ(*read_file(file), "# title: A talk\nBeg_Stream\n26:50;500\nEnd_Stream\n");
  ask(gui::NewComposition{});
  ask(gui::AddKeyframe{});
  ASSERT_TRUE(composer_->save(folder.path() / "new.txt"));
  EXPECT_EQ(*read_file(folder.path() / "new.txt"), "Beg_Stream\n0;500\nEnd_Stream\n")
      << "the title is of the other stream";
}

TEST_F(ComposerSessionTest, AFileThatIsNoStreamChangesNothing) {
  const test::TempFolder folder;
  ask(gui::ComposeAu{26, 100, 100, false});
  ask(gui::AddKeyframe{});
  EXPECT_EQ(composer_->load(folder.write("none.txt", "no stream")).error().kind,
            ErrorKind::BadData);
  EXPECT_EQ(composer_->load(folder.path() / "absent.txt").error().kind, ErrorKind::Unreadable);
  EXPECT_EQ(composer_->keyframes().size(), 1U);
  EXPECT_TRUE(composer_->unsaved());
  EXPECT_FALSE(composer_->save(folder.path() / "no" / "such.txt").has_value());
  EXPECT_TRUE(composer_->unsaved());
}

}  // namespace
}  // namespace aucast::app
