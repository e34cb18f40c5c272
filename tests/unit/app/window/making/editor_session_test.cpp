#include "client/app/window/making/editor_session.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/gui/storage/user_face.h"
#include "client/gui/texts/texts.h"
#include "protocol/codec.h"
#include "tests/support/manual_clock.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::app {
namespace {

/// On the small face, as if it had come with the player: AUs 6, 12, 15, 26, 43 and some more. The
/// user's own faces are in a folder of the test.
class EditorSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(::setenv("XDG_DATA_HOME", home_.path().c_str(), 1), 0);
    assets_.data_folder = data_.path();
    assets_.face_folder = data_.path() / "faces" / "small";
    const test::TempFolder made;
    face::test::write_small_face(made);
    std::filesystem::create_directories(data_.path() / "faces");
    std::filesystem::copy(made.path(), assets_.face_folder,
                          std::filesystem::copy_options::recursive);
    auto face = face::load_face(assets_.face_folder, assets_.data_folder);
    ASSERT_TRUE(face.has_value()) << face.error().message;
    assets_.face = std::move(*face);
    assets_.expressions.push_back({"smile", "Smile", aus_of("12"), {}, "", {}});
    assets_.expressions.push_back({"yawn", "Yawn", aus_of("26"), {{"jaw", {}, 3, 3}}, "", {}});
    assets_.expressions.push_back({"smile_2", "Smile", aus_of("6,12"), {}, "", {}});
    assets_.expressions.push_back({"odd", "Odd", {}, {{"no_such_muscle", {}, 1, 1}}, "", {}});
    mapping_.emplace(pipeline::AuMapping{assets_.face, assets_.face.recordings, {}});
    shown_.assign(assets_.face.channels.size(), 0.0F);
    editor_.emplace(assets_, *mapping_, notices_, shown_);
  }
  void TearDown() override { ASSERT_EQ(::unsetenv("XDG_DATA_HOME"), 0); }

  static AuFrame aus_of(const char* text) { return *protocol::parse_au_set(text); }
  bool ask(const gui::EditorCommand& command) {
    return editor_->apply(command, true, clock_.now());
  }
  [[nodiscard]] std::size_t channel(const char* name) const {
    return *assets_.face.channel_index(name);
  }
  bool set(const char* name, float value, bool continued = false) {
    return ask(gui::SetChannel{static_cast<int>(channel(name)), value, continued});
  }
  [[nodiscard]] float at(const char* name) const {
    return editor_->activations(clock_.now())[channel(name)];
  }
  [[nodiscard]] std::vector<std::string> names_of_channels() const {
    std::vector<std::string> names;
    for (const face::Channel& one : assets_.face.channels) names.push_back(one.name);
    return names;
  }
  /// As the window does when AUs were saved: the face is the user's copy from now on.
  void show_saved_face() {
    assets_.face_folder = editor_->take_saved_face();
    auto face = face::load_face(assets_.face_folder, assets_.data_folder);
    ASSERT_TRUE(face.has_value()) << face.error().message;
    assets_.face = std::move(*face);
    mapping_->recordings = assets_.face.recordings;
    editor_->change_face(names_of_channels());
  }
  /// The way to an expression is over.
  void arrive() { clock_.advance(std::chrono::seconds(1)); }
  /// As the list of AUs has it; number 0: it does not.
  [[nodiscard]] gui::AuEntry entry(int number) const {
    for (const gui::AuEntry& one : *editor_->known_aus()) {
      if (one.number == number) return one;
    }
    return {};
  }

  test::TempFolder home_;
  test::TempFolder data_;
  test::ManualClock clock_;
  Notices notices_;
  Assets assets_;
  std::optional<pipeline::AuMapping> mapping_;
  std::vector<float> shown_;
  std::optional<EditorSession> editor_;
};

TEST_F(EditorSessionTest, AnExpressionIsReachedFromTheFaceThatIsShown) {
  shown_[channel("jaw")] = 2;
  EXPECT_TRUE(ask(gui::ShowExpression{0}));
  EXPECT_EQ(at("jaw"), 2) << "not yet on its way";
  ASSERT_TRUE(editor_->next_frame_at(clock_.now()).has_value());
  clock_.advance(Milliseconds(125));
  EXPECT_GT(at("jaw"), 0);
  EXPECT_LT(at("jaw"), 2);
  arrive();
  EXPECT_EQ(at("jaw"), 0);
  EXPECT_FLOAT_EQ(at("left_zygomaticus_major"), 1.5F);
  EXPECT_EQ(editor_->next_frame_at(clock_.now()), std::nullopt);
}

TEST_F(EditorSessionTest, OneButtonOfEachNameIsAmongTheMainOnes) {
  const auto& buttons = editor_->expressions().buttons;
  ASSERT_EQ(buttons.size(), 4U);
  EXPECT_EQ(buttons[0].kind, gui::ExpressionKind::Main);
  EXPECT_EQ(buttons[1].kind, gui::ExpressionKind::Macro);
  EXPECT_EQ(buttons[2].kind, gui::ExpressionKind::Other);
  EXPECT_EQ(buttons[2].label, "Smile") << "in words, as translations have it";
  EXPECT_EQ(buttons[2].name, "smile_2");
}

TEST_F(EditorSessionTest, TheStrengthIsThatOfTheChosenExpression) {
  EXPECT_FALSE(ask(gui::ChangeStrength{50})) << "none is chosen, and no face changes";
  EXPECT_TRUE(ask(gui::ShowExpression{0}));
  arrive();
  EXPECT_FLOAT_EQ(at("left_zygomaticus_major"), 0.75F);
  EXPECT_EQ(editor_->expressions().aus, "12:50");
  EXPECT_TRUE(ask(gui::ChangeStrength{100}));
  arrive();
  EXPECT_FLOAT_EQ(at("left_zygomaticus_major"), 1.5F);
}

TEST_F(EditorSessionTest, AnExpressionThatTheFaceCannotShowIsSaidAndNotChosen) {
  EXPECT_FALSE(ask(gui::ShowExpression{3}));
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_NE(notices_.view().text.find("no_such_muscle"), std::string::npos);
  EXPECT_EQ(editor_->expressions().chosen, -1);
  EXPECT_FALSE(ask(gui::ShowExpression{4})) << "there is none";
}

TEST_F(EditorSessionTest, WhatTheFaceIsMadeOfIsKnownUntilAMuscleIsMoved) {
  ask(gui::ShowExpression{0});
  EXPECT_EQ(editor_->aus(), aus_of("12"));
  ask(gui::ShowExpression{1});
  EXPECT_EQ(editor_->aus(), std::nullopt) << "of muscles";
  EXPECT_EQ(editor_->made_of(), "yawn");
  ask(gui::LoadAu{12});
  EXPECT_EQ(editor_->aus(), aus_of("12"));
  set("jaw", 1);
  EXPECT_EQ(editor_->aus(), std::nullopt);
  EXPECT_EQ(editor_->made_of(), "au12_edited");
}

TEST_F(EditorSessionTest, AMuscleThatIsMovedEndsTheWayAndTheChoice) {
  ask(gui::ShowExpression{0});
  EXPECT_TRUE(set("jaw", 1));
  EXPECT_EQ(editor_->next_frame_at(clock_.now()), std::nullopt);
  EXPECT_FLOAT_EQ(at("left_zygomaticus_major"), 1.5F) << "the expression is there at once";
  EXPECT_EQ(editor_->expressions().chosen, -1);
  EXPECT_FALSE(ask(gui::SetChannel{-1, 1, false}));
  EXPECT_FALSE(ask(gui::SetChannel{10'000, 1, false}));
}

TEST_F(EditorSessionTest, ADragIsOneStepToTakeBack) {
  set("jaw", 1);
  set("jaw", 2, true);
  set("jaw", 3, true);
  ask(gui::Undo{});
  EXPECT_EQ(at("jaw"), 0);
  EXPECT_FALSE(editor_->view(true).can_undo);
  ask(gui::Redo{});
  EXPECT_EQ(at("jaw"), 3);
}

TEST_F(EditorSessionTest, AusThatAreNoSetAreSaidAndTheComplaintGoesWithThem) {
  EXPECT_FALSE(ask(gui::ShowAus{"12,"}));
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_TRUE(editor_->view(true).compound.empty());
  EXPECT_TRUE(ask(gui::ShowAus{"12,26:40"}));
  EXPECT_EQ(notices_.view().text, "");
  ASSERT_EQ(editor_->view(true).compound.size(), 2U);
  EXPECT_EQ(editor_->view(true).compound[1].received_percent, 40);
  editor_->put_away();
  EXPECT_TRUE(editor_->view(true).compound.empty());
}

TEST_F(EditorSessionTest, AnAuIsSavedIntoACopyOfTheFace) {
  ask(gui::LoadAu{26});
  EXPECT_FALSE(editor_->unsaved());
  set("jaw", 1);
  EXPECT_TRUE(editor_->unsaved());
  ask(gui::SaveAu{26});
  EXPECT_FALSE(notices_.view().bad) << notices_.view().text;
  EXPECT_FALSE(editor_->unsaved());
  const auto copy = home_.path() / "aucast" / "faces" / "small";
  EXPECT_EQ(editor_->take_saved_face(), copy.string());
  EXPECT_FLOAT_EQ(mapping_->recordings.at(26).activation[channel("jaw")], 1)
      << "what plays has it at once";
  const auto saved = face::load_face(copy, assets_.data_folder);
  ASSERT_TRUE(saved.has_value()) << saved.error().message;
  EXPECT_FLOAT_EQ(saved->recordings.at(26).activation[channel("jaw")], 1);
}

TEST_F(EditorSessionTest, ShippedFacesInThePlaceOfOnesOwnAreNotSavedTo) {
  std::filesystem::create_directories(home_.path() / "aucast");
  std::filesystem::create_directory_symlink(data_.path() / "faces",
                                            home_.path() / "aucast" / "faces");
  const std::string before = data_.read("faces/small/aus.toml");
  editor_->change_face(names_of_channels());
  ask(gui::LoadAu{26});
  set("jaw", 3.5F);
  ask(gui::SaveAu{26});
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_NE(notices_.view().text.find("leads to the shipped faces"), std::string::npos)
      << notices_.view().text;
  EXPECT_EQ(data_.read("faces/small/aus.toml"), before);
}

TEST_F(EditorSessionTest, AnAuWithoutANameIsNotSavedAndItsNameIsKeptUntilThen) {
  set("jaw", 3);
  ask(gui::SaveAu{77});
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_EQ(notices_.view().text, gui::tr("said.au_unnamed", 77));
  ask(gui::NameAu{77, " wide "});
  EXPECT_EQ(editor_->view(true).names.at(77), " wide ");
  ask(gui::SaveAu{77});
  EXPECT_FALSE(notices_.view().bad) << notices_.view().text;
  EXPECT_EQ(entry(77).name, "wide");
  EXPECT_FALSE(entry(77).shipped);
  EXPECT_TRUE(editor_->view(true).names.empty());
}

TEST_F(EditorSessionTest, OnlyAnAuOfOnesOwnCanBeRemoved) {
  EXPECT_FALSE(ask(gui::RemoveAu{12})) << "it came with the face";
  EXPECT_EQ(entry(12).number, 12);
}

TEST_F(EditorSessionTest, AnAuOfOnesOwnIsAsItCameAgainWhenItIsRemoved) {
  ask(gui::LoadAu{26});
  set("jaw", 1);
  ask(gui::SaveAu{26});
  show_saved_face();
  EXPECT_TRUE(entry(26).own);
  EXPECT_TRUE(ask(gui::RemoveAu{26}));
  EXPECT_EQ(notices_.view().text, gui::tr("said.au_shipped", 26));
  EXPECT_FALSE(entry(26).own);
  EXPECT_FLOAT_EQ(mapping_->recordings.at(26).activation[channel("jaw")], 2.2F);
}

TEST_F(EditorSessionTest, AnAuOfAFaceFromElsewhereIsNotThatOfTheShippedOneOfItsName) {
  const test::TempFolder elsewhere;
  const std::filesystem::path other = elsewhere.path() / "small";
  std::filesystem::copy(assets_.face_folder, other, std::filesystem::copy_options::recursive);
  ASSERT_TRUE(gui::save_aus(other, {{26, {{"jaw", 2.5F}}, {}}}));
  assets_.face_folder = other;
  auto face = face::load_face(other, assets_.data_folder);
  ASSERT_TRUE(face.has_value()) << face.error().message;
  assets_.face = std::move(*face);
  mapping_->recordings = assets_.face.recordings;
  editor_->change_face(names_of_channels());
  ask(gui::LoadAu{26});
  set("jaw", 3.5F);
  ask(gui::SaveAu{26});
  ASSERT_FALSE(notices_.view().bad) << notices_.view().text;
  show_saved_face();
  EXPECT_TRUE(entry(26).own);
  EXPECT_FALSE(entry(12).own);
  ask(gui::RemoveAu{26});
  EXPECT_FALSE(entry(26).own);
  const auto saved = face::load_face(assets_.face_folder, assets_.data_folder);
  ASSERT_TRUE(saved.has_value()) << saved.error().message;
  EXPECT_FLOAT_EQ(saved->recordings.at(26).activation[channel("jaw")], 2.5F);
}

TEST_F(EditorSessionTest, AnAuThatIsOnlyOnesOwnIsGoneWhenItIsRemovedAndKeepsItsName) {
  set("jaw", 3);
  ask(gui::SaveAu{77, "wide"});
  show_saved_face();
  EXPECT_TRUE(ask(gui::RemoveAu{77}));
  EXPECT_EQ(notices_.view().text, gui::tr("said.au_deleted", 77));
  EXPECT_EQ(entry(77).number, 0);
  EXPECT_FALSE(editor_->unsaved());
  ask(gui::SaveAu{77});
  EXPECT_FALSE(notices_.view().bad) << notices_.view().text;
  EXPECT_EQ(entry(77).name, "wide");
}

TEST_F(EditorSessionTest, AusOfAFileBecomeOnesOwnAndTheFirstIsShown) {
  const auto file = data_.write("two.toml",
                                "[[au]]\nnumber = 26\ndrive = { jaw = 2.0 }\n"
                                "[[au]]\nnumber = 77\nnote = \"Yell\"\ndrive = { jaw = 4.0 }\n");
  const auto imported = editor_->import_aus(file);
  ASSERT_TRUE(imported.has_value()) << imported.error().message;
  const auto aus = home_.path() / "aucast" / "faces" / "small";
  EXPECT_EQ(editor_->take_saved_face(), aus.string());
  EXPECT_NE(imported->find("26, 77"), std::string::npos) << *imported;
  EXPECT_EQ(at("jaw"), 2);
  EXPECT_EQ(editor_->au(), 26);
  EXPECT_EQ(entry(77).name, "Yell");
}

TEST_F(EditorSessionTest, AnotherFaceSaysHowWhatIsNotSavedComesBack) {
  const std::vector<gui::EditorCommand> others = {gui::ShowExpression{0}, gui::ShowAus{"12"},
                                                  gui::LoadAu{26}};
  for (const gui::EditorCommand& other : others) {
    ask(other);
    EXPECT_EQ(notices_.view().text, "") << "there was nothing: " << other.index();
    set("jaw", 3);
    ask(other);
    EXPECT_EQ(notices_.view().text, gui::tr("said.edit_replaced")) << other.index();
    EXPECT_FALSE(notices_.view().bad);
    EXPECT_FALSE(editor_->unsaved());
    ask(gui::Undo{});
    EXPECT_EQ(at("jaw"), 3);
    EXPECT_TRUE(editor_->unsaved());
    ask(gui::Undo{});
    notices_.clear();
  }
}

TEST_F(EditorSessionTest, AnExpressionThatCannotBeShownReplacesNothing) {
  set("jaw", 3);
  EXPECT_FALSE(ask(gui::ShowExpression{3}));
  EXPECT_NE(notices_.view().text, gui::tr("said.edit_replaced"));
  EXPECT_TRUE(editor_->unsaved());
}

TEST_F(EditorSessionTest, AusOfAFileSayHowWhatIsNotSavedComesBack) {
  const auto file = data_.write("one.toml", "[[au]]\nnumber = 26\ndrive = { jaw = 2.0 }\n");
  set("jaw", 3);
  const auto imported = editor_->import_aus(file);
  ASSERT_TRUE(imported.has_value()) << imported.error().message;
  EXPECT_TRUE(imported->ends_with(gui::tr("said.edit_replaced"))) << *imported;
  ask(gui::Undo{});
  EXPECT_EQ(at("jaw"), 3);
  EXPECT_TRUE(editor_->unsaved());
}

TEST_F(EditorSessionTest, OnAnotherFaceTheSameAusAreShown) {
  ask(gui::ShowAus{"26"});
  arrive();
  mapping_->recordings.at(26).activation[channel("jaw")] = 1;
  editor_->change_face(names_of_channels());
  EXPECT_EQ(at("jaw"), 1) << "as this face shows them";
  EXPECT_EQ(editor_->aus(), aus_of("26"));
}

TEST_F(EditorSessionTest, WhatIsShownHasANameForFiles) {
  EXPECT_EQ(editor_->made_of(), "edited");
  ask(gui::ShowExpression{1});
  EXPECT_EQ(editor_->made_of(), "yawn");
  ask(gui::LoadAu{26});
  EXPECT_EQ(editor_->made_of(), "au26_edited");
}

TEST_F(EditorSessionTest, AFileThatHasNoAusIsRefused) {
  const auto none = data_.write("none.toml", "[[au]]\nnumber = 0\ndrive = { jaw = 1.0 }\n");
  const auto imported = editor_->import_aus(none);
  ASSERT_FALSE(imported.has_value());
  EXPECT_NE(imported.error().message.find(gui::tr("said.no_aus")), std::string::npos)
      << imported.error().message;
  EXPECT_FALSE(editor_->import_aus("/no/such/aus.toml").has_value());
  EXPECT_EQ(editor_->take_saved_face(), "");
}

TEST_F(EditorSessionTest, WithoutAnAuThereIsNoneToExport) {
  const auto exported = editor_->export_au(data_.path() / "au.toml");
  ASSERT_FALSE(exported.has_value());
  EXPECT_EQ(exported.error().message, gui::tr("said.no_au"));
  ask(gui::LoadAu{26});
  ASSERT_TRUE(editor_->export_au(data_.path() / "au.toml").has_value());
  EXPECT_NE(data_.read("au.toml").find("number = 26"), std::string::npos);
}

}  // namespace
}  // namespace aucast::app
