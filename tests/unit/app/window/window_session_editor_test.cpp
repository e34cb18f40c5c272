// Expressions, AUs put together and edited AUs, beside what plays and what is composed.
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"

namespace aucast::app {
namespace {

using gui::Activity;
using EditedSessionTest = PlayedSession;

TEST_F(EditedSessionTest, AnExpressionIsReachedFromTheFaceAsItIs) {
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

TEST_F(EditedSessionTest, AnExpressionIsNotChosenAnyMoreWhenAnotherFaceIsShown) {
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

TEST_F(EditedSessionTest, AnExpressionIsShownAsStronglyAsAsked) {
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

TEST_F(EditedSessionTest, AnotherExpressionBeginsAtFullStrength) {
  open_nothing();
  ask(gui::ShowExpression{expression("happiness")});
  ask(gui::ChangeStrength{40, false});
  ask(gui::ShowExpression{expression("happiness")});
  EXPECT_EQ(model().expressions.percent, 40) << "it is the same one";
  ask(gui::ShowExpression{expression("anger")});
  EXPECT_EQ(model().expressions.percent, 100);
  ask(gui::ChangeStrength{30, false});
  ask(gui::NeutralFace{});
  ask(gui::ShowExpression{expression("happiness")});
  EXPECT_EQ(model().expressions.percent, 100);
}

TEST_F(EditedSessionTest, TheTableOfAusIsOfTheFaceThatIsShown) {
  open({frame({{4, Side::Both, 100}}), frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  const auto numbers = [this] {
    std::vector<std::string> labels;
    for (const gui::AuRow& row : model().playing.aus) labels.push_back(row.label);
    return labels;
  };
  EXPECT_EQ(numbers(), std::vector<std::string>{"4"});
  ask(gui::ShowExpression{expression("happiness")});
  EXPECT_EQ(numbers(), (std::vector<std::string>{"6", "12"}));
  ask(gui::ShowExpression{expression("waters-happiness")});
  EXPECT_TRUE(numbers().empty()) << "muscles are no AUs";
  ask(gui::LoadAu{12});
  EXPECT_EQ(numbers(), std::vector<std::string>{"12"});
  ask(gui::ComposeAu{26, 50, 50, false});
  EXPECT_EQ(numbers(), std::vector<std::string>{"26"});
  ask(gui::Resume{});
  EXPECT_EQ(numbers(), std::vector<std::string>{"4"});
}

TEST_F(EditedSessionTest, AMacroIsShownAsStronglyAsAsked) {
  open_nothing();
  ask(gui::ChangeStrength{50, false});
  ask(gui::ShowExpression{expression("waters-happiness")});
  clock_.advance(Milliseconds(250));
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), 0.5F);
  EXPECT_EQ(model().expressions.aus, "") << "muscles are no AUs";
}

TEST_F(EditedSessionTest, TheComposerTakesTheFaceThatIsShown) {
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
  ASSERT_TRUE(session_->face().aus().has_value());
  EXPECT_FLOAT_EQ(session_->face().aus()->right[12], 0.6F);
}

TEST_F(EditedSessionTest, EveryKindOfExpressionHasOneButton) {
  using gui::ExpressionKind;
  open_nothing();
  const auto all = model().expressions.buttons;
  EXPECT_EQ(all.size(), assets_->expressions.size());
  std::set<std::string> labels;
  std::set<std::string> others;
  int macros = 0;
  for (const gui::ExpressionButton& one : all) {
    macros += one.kind == ExpressionKind::Macro ? 1 : 0;
    if (one.kind == ExpressionKind::Macro) continue;
    const bool main = one.kind == ExpressionKind::Main;
    const std::string line = one.label + " " + one.aus + " " + one.source;
    EXPECT_TRUE(main ? labels.insert(one.label).second : others.insert(line).second)
        << line << " is there twice";
  }
  EXPECT_EQ(all.front().kind, ExpressionKind::Main);
  EXPECT_EQ(macros, 6);
}

TEST_F(EditedSessionTest, SeveralAusTogetherGoThroughRulesAndMixer) {
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
  ask(gui::Undo{});
  ask(gui::ShowAus{"12"});
  EXPECT_EQ(model().notice.text, "") << "the mistake is mended";
}

TEST_F(EditedSessionTest, EveryAuHasItsMusclesAndWhatItLooksLike) {
  open_nothing();
  ASSERT_NE(model().known_aus, nullptr);
  EXPECT_GT(model().known_aus->size(), 40U);
  for (const gui::AuEntry& entry : *model().known_aus) {
    EXPECT_FALSE(entry.name.empty()) << entry.number;
    EXPECT_FALSE(entry.muscles.empty()) << entry.number;
    EXPECT_FALSE(entry.looks.empty()) << entry.number;
  }
}

TEST_F(EditedSessionTest, UndoIsOfWhatTheFaceShows) {
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

TEST_F(EditedSessionTest, AMacroSetsItsMuscles) {
  open_nothing();
  ask(gui::ShowExpression{expression("waters-happiness")});
  clock_.advance(Milliseconds(250));
  EXPECT_FLOAT_EQ(shown("left_zygomaticus_major"), 1.0F);
  EXPECT_FLOAT_EQ(shown("right_zygomaticus_major"), 1.1F);
}

TEST_F(EditedSessionTest, EditingHoldsWhatPlaysAndResumeGivesTheFaceBack) {
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(50));
  const float half = shown("jaw");
  ask(gui::SetChannel{channel("jaw"), 4, false});
  EXPECT_EQ(shown("jaw"), 4);
  EXPECT_EQ(model().playing.activity, Activity::Paused);
  ask(gui::Resume{});
  EXPECT_EQ(shown("jaw"), half);
  EXPECT_FALSE(model().editor.active);
}

TEST_F(EditedSessionTest, ChannelsThatAreNotThereAreIgnored) {
  open_nothing();
  ask(gui::SetChannel{-1, 1, false});
  ask(gui::SetChannel{100'000, 1, false});
  ask(gui::ShowExpression{100'000});
  EXPECT_FALSE(model().editor.active);
}

TEST_F(EditedSessionTest, AnEditedAuIsSavedInTheUsersFolderAndPlayed) {
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

/// What the sliders say of a channel.
float slider_of(const gui::EditorView& editor, int channel) {
  for (const gui::ChannelGroup& group : editor.groups) {
    for (const gui::ChannelRow& row : group.rows) {
      if (row.left == channel) return row.left_value;
      if (row.right == channel) return row.right_value;
    }
  }
  return -1;
}

TEST_F(EditedSessionTest, AnAuStaysWhatIsEditedWhileAStreamPlays) {
  open({frame({{26, Side::Both, 100}})});
  ask(gui::LoadAu{4});
  const float brow = slider_of(model().editor, channel("left_brow_adductor"));
  ASSERT_GT(brow, 0);
  EXPECT_FALSE(model().editor.aside);
  ask(gui::Resume{});
  go_on(Milliseconds(0));
  go_on(Milliseconds(100));
  ASSERT_GT(shown("jaw"), 0) << "the face is the stream's";
  EXPECT_TRUE(model().editor.aside);
  EXPECT_EQ(model().editor.au, 4);
  EXPECT_EQ(slider_of(model().editor, channel("left_brow_adductor")), brow);
  EXPECT_EQ(slider_of(model().editor, channel("jaw")), 0) << "the stream's face is not saved";
  ask(gui::SetChannel{channel("left_brow_adductor"), brow / 2, false});
  EXPECT_EQ(model().editor.au, 4) << "it is still the one that is chosen";
  EXPECT_FLOAT_EQ(shown("left_brow_adductor"), brow / 2);
  EXPECT_EQ(shown("jaw"), 0);
  EXPECT_FALSE(model().editor.aside);
}

TEST_F(EditedSessionTest, WhatIsEditedIsShownAgainWhenAsked) {
  open({frame({{26, Side::Both, 100}})});
  ask(gui::LoadAu{4});
  ask(gui::Resume{});
  EXPECT_FALSE(model().editor.active);
  ask(gui::ShowEdited{});
  EXPECT_TRUE(model().editor.active);
  EXPECT_EQ(model().editor.au, 4);
  EXPECT_EQ(model().playing.activity, Activity::Paused);
}

TEST_F(EditedSessionTest, TheFaceThatTheSlidersShowIsTheOneThatIsSaved) {
  const test::TempFolder home;
  ASSERT_EQ(::setenv("XDG_DATA_HOME", home.path().c_str(), 1), 0);
  open({frame({{26, Side::Both, 100}})});
  go_on(Milliseconds(0));
  go_on(Milliseconds(100));
  const float jaw = shown("jaw");
  ASSERT_GT(jaw, 0);
  ASSERT_EQ(slider_of(model().editor, channel("jaw")), jaw) << "no AU is chosen";
  ask(gui::SaveAu{90, "open"});
  const std::filesystem::path copy = home.path() / "aucast" / "faces" / "default";
  const auto face = face::load_face(copy, assets_->data_folder);
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_NEAR(face->recordings.at(90).activation[*face->channel_index("jaw")], jaw, 0.01);
  ask(gui::ShowAus{"90"});
  ASSERT_EQ(model().editor.compound.size(), 1U);
  EXPECT_EQ(model().editor.compound[0].name, "open");
  ASSERT_EQ(::unsetenv("XDG_DATA_HOME"), 0);
  session_.reset();
  SetUpTestSuite();  // the face of the assets is the copy now
}

TEST_F(EditedSessionTest, ASavingThatFailsIsSaidAndLosesNothing) {
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

TEST_F(EditedSessionTest, AnExpressionThatReplacesWhatIsNotSavedSaysThatUndoBringsItBack) {
  open_nothing();
  ask(gui::SetChannel{channel("head_turn_left"), 0.59F, false});
  EXPECT_TRUE(model().notice.text.empty());
  ask(gui::ShowExpression{expression("surprise")});
  EXPECT_EQ(model().notice.text,
            "another face is in the editor: Undo (Ctrl+Z) brings back what is not saved");
  session_->undo(clock_.now());
  EXPECT_FLOAT_EQ(shown("head_turn_left"), 0.59F);
  session_->ask_to_leave();
  EXPECT_TRUE(model().asks_to_leave);
}

TEST_F(EditedSessionTest, LeavingAsksWhenSomethingIsNotSaved) {
  open_nothing();
  ask(gui::SetChannel{channel("jaw"), 1, false});
  session_->ask_to_leave();
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().asks_to_leave);
  ask(gui::Leave{false});
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_FALSE(model().asks_to_leave);
  ask(gui::Undo{});
  session_->ask_to_leave();
  EXPECT_TRUE(session_->leaving().leaves());
}

}  // namespace
}  // namespace aucast::app
