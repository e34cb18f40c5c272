#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"
#include "tests/unit/face/small_face.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

/// A face of one's own is the small one, with channels of its own. Each test has assets of its own,
/// because their face becomes another one.
class WindowSessionFaceTest : public SessionOnDefaultFace {
 protected:
  void SetUp() override {
    if (assets_ == nullptr || assets_->face.name != "default") SetUpTestSuite();
    ASSERT_EQ(::setenv("XDG_DATA_HOME", home_.path().c_str(), 1), 0);
    face::test::write_small_face(made_);
    fs::create_directories(home_.path() / "aucast" / "faces");
    fs::copy(made_.path(), small_, fs::copy_options::recursive);
    session_.emplace(*assets_, options_, nullptr, stats_);
  }
  void TearDown() override {
    session_.reset();
    assets_.reset();
    ASSERT_EQ(::unsetenv("XDG_DATA_HOME"), 0);
  }
  void ask(const gui::GuiCommand& command) { session_->apply(command, clock_.now()); }
  [[nodiscard]] int channel(const char* name) const {
    return static_cast<int>(*assets_->face.channel_index(name));
  }

  test::TempFolder home_;
  test::TempFolder made_;
  fs::path small_ = home_.path() / "aucast" / "faces" / "small";
};

/// The entry of an AU in the editor's list; none: number 0.
gui::AuEntry entry_of(const gui::GuiModel& model, int number) {
  for (const gui::AuEntry& entry : *model.known_aus) {
    if (entry.number == number) return entry;
  }
  return {};
}

TEST_F(WindowSessionFaceTest, ShippedOnesAndOnesOwnAreThereToChoose) {
  const gui::FacesView& faces = model().faces;
  const auto has = [&](const std::string& name, gui::FaceKind kind) {
    return std::any_of(faces.entries->begin(), faces.entries->end(),
                       [&](const auto& entry) { return entry.name == name && entry.kind == kind; });
  };
  EXPECT_TRUE(has("default", gui::FaceKind::Shipped));
  EXPECT_TRUE(has("marek", gui::FaceKind::Shipped));
  EXPECT_TRUE(has("small", gui::FaceKind::Own));
  EXPECT_EQ(fs::path(faces.shown).filename(), "default");
  EXPECT_EQ(faces.shown, faces.entries->front().folder);
}

TEST_F(WindowSessionFaceTest, WhatPlaysGoesOnOnAnotherFace) {
  const test::TempFolder folder;
  ask(gui::OpenStream{folder.write("jaw.txt", "Beg_Stream\n26;100\n0;200\nEnd_Stream\n").string()});
  go_on(Milliseconds(0));
  go_on(Milliseconds(150));
  EXPECT_GT(shown("jaw"), 0);
  ask(gui::ShowFace{small_.string()});
  EXPECT_EQ(session_->faces().changes(), 1U);
  ASSERT_EQ(session_->face().activations(clock_.now()).size(), assets_->face.channels.size());
  const auto& recording = assets_->face.recordings.at(26).activation;
  const float whole = recording[static_cast<std::size_t>(channel("jaw"))];
  EXPECT_FLOAT_EQ(shown("jaw"), whole * 0.75F) << "the jaw of this face, at the same place";
  EXPECT_EQ(model().playing.activity, gui::Activity::Playing);
  EXPECT_EQ(model().local.position, Milliseconds(150));
  go_on(Milliseconds(100));
  EXPECT_FLOAT_EQ(shown("jaw"), whole * 0.25F);
}

TEST_F(WindowSessionFaceTest, TheNextStartShowsTheFaceThatWasChosen) {
  EXPECT_EQ(session_->kept().face, "");
  ask(gui::ShowFace{small_.string()});
  EXPECT_EQ(session_->kept().face, small_.string());
  EXPECT_EQ(model().faces.shown, small_.string());
  ask(gui::ShowFace{(assets_->data_folder / "faces" / "marek").string()});
  EXPECT_EQ(session_->kept().face, "marek") << "shipped faces may lie elsewhere next time";
}

TEST_F(WindowSessionFaceTest, AShippedFaceIsListedOnceHoweverItsFolderIsReached) {
  const std::size_t listed = model().faces.entries->size();
  const test::TempFolder folder;
  const fs::path way = folder.path() / "way";
  fs::create_directory_symlink(fs::absolute(assets_->data_folder / "faces"), way);
  ask(gui::OpenStream{(way / "marek" / "face.toml").string()});
  EXPECT_EQ(assets_->face.name, "marek");
  EXPECT_EQ(model().faces.entries->size(), listed);
  EXPECT_EQ(std::count_if(model().faces.entries->begin(), model().faces.entries->end(),
                          [&](const auto& one) { return one.folder == model().faces.shown; }),
            1);
  EXPECT_EQ(session_->kept().face, "marek");
}

TEST_F(WindowSessionFaceTest, AShippedFaceIsListedOnceWhenACopyOfItIsOpened) {
  const gui::FacesView before = model().faces;
  const test::TempFolder folder;
  const fs::path copy = folder.path() / "marek";
  for (const char* name : {"default", "marek"}) {
    fs::copy(assets_->data_folder / "faces" / name, folder.path() / name,
             fs::copy_options::recursive);
  }
  ask(gui::OpenStream{(copy / "face.toml").string()});
  EXPECT_EQ(assets_->face.name, "marek");
  EXPECT_EQ(*model().faces.entries, *before.entries);
  EXPECT_EQ(fs::path(model().faces.shown).parent_path(), fs::path(before.shown).parent_path())
      << "it is marked where it is listed";
  EXPECT_EQ(session_->kept().face, copy.string()) << "the next start shows what was chosen";
  fs::copy(made_.path(), folder.path() / "anna", fs::copy_options::recursive);
  ask(gui::ShowFace{(folder.path() / "anna").string()});
  ASSERT_EQ(model().faces.entries->size(), before.entries->size() + 1) << "nor as a neighbour";
  EXPECT_EQ(model().faces.entries->back().name, "anna");
  std::ofstream(copy / "face.toml", std::ios::app) << "# changed\n";
  ask(gui::ShowFace{copy.string()});
  EXPECT_EQ(model().faces.shown, copy.string()) << "one that was changed is another one";
  EXPECT_EQ(model().faces.entries->size(), before.entries->size() + 2);
  fs::copy(assets_->data_folder / "faces" / "marek" / "face.toml", copy,
           fs::copy_options::overwrite_existing);
  std::ofstream(folder.path() / "default" / "aus.toml", std::ios::app) << "# changed\n";
  ask(gui::ShowFace{copy.string()});
  EXPECT_EQ(model().faces.shown, copy.string()) << "as is one that uses what was changed";
}

TEST_F(WindowSessionFaceTest, AnUnchangedCopyOfOnesOwnIsOnesOwn) {
  const fs::path copy = home_.path() / "aucast" / "faces" / "default";
  fs::copy(assets_->data_folder / "faces" / "default", copy, fs::copy_options::recursive);
  ask(gui::ShowFace{copy.string()});
  EXPECT_EQ(model().faces.shown, copy.string());
  EXPECT_EQ(std::count_if(model().faces.entries->begin(), model().faces.entries->end(),
                          [](const auto& one) { return one.name == "default"; }),
            2);
}

TEST_F(WindowSessionFaceTest, ACopyIsMadeOnPurposeAndShown) {
  const std::string shipped = model().faces.shown;
  ask(gui::LoadAu{12});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::CopyFace{shipped, "anna"});
  const fs::path copy = home_.path() / "aucast" / "faces" / "anna";
  EXPECT_FALSE(model().notice.bad) << model().notice.text;
  EXPECT_NE(model().notice.text.find(copy.string()), std::string::npos) << model().notice.text;
  EXPECT_EQ(model().faces.shown, copy.string());
  EXPECT_EQ(session_->kept().face, copy.string()) << "the next start shows it";
  EXPECT_EQ(assets_->face.name, "anna");
  EXPECT_TRUE(model().editor.unsaved) << "what is edited stays";
  ask(gui::SaveAu{12});
  EXPECT_EQ(model().faces.shown, copy.string()) << "it is saved where one is";
  EXPECT_TRUE(entry_of(model(), 12).own);
  EXPECT_FALSE(entry_of(model(), 6).own) << "that one is as in the face that was copied";
  ask(gui::RemoveAu{12});
  EXPECT_FALSE(entry_of(model(), 12).own);
  EXPECT_FALSE(fs::exists(home_.path() / "aucast" / "faces" / "default"));
}

TEST_F(WindowSessionFaceTest, InACopyOfAFaceFromElsewhereOnlyWhatWasChangedIsOnesOwn) {
  ask(gui::CopyFace{made_.path().string(), "anna"});
  for (const gui::AuEntry& entry : *model().known_aus) EXPECT_FALSE(entry.own) << entry.number;
  ask(gui::LoadAu{26});
  const float jaw = shown("jaw");
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::SaveAu{26});
  EXPECT_TRUE(entry_of(model(), 26).own);
  ask(gui::RemoveAu{26});
  EXPECT_FALSE(entry_of(model(), 26).own);
  EXPECT_EQ(entry_of(model(), 26).number, 26) << "it is as it came";
  EXPECT_FLOAT_EQ(shown("jaw"), jaw);
}

TEST_F(WindowSessionFaceTest, ANameThatCannotBeTakenChangesNothing) {
  const std::string shipped = model().faces.shown;
  for (const char* name : {"", "small", "marek", "a/b", "..", "../small"}) {
    ask(gui::CopyFace{shipped, name});
    EXPECT_TRUE(model().notice.bad) << name;
    ask(gui::RenameFace{small_.string(), name});
    EXPECT_TRUE(model().notice.bad) << name;
  }
  EXPECT_EQ(session_->faces().changes(), 0U);
  EXPECT_EQ(std::distance(fs::directory_iterator(small_.parent_path()), {}), 1);
}

TEST_F(WindowSessionFaceTest, ARenamedFaceStaysTheOneThatIsShown) {
  ask(gui::ShowFace{small_.string()});
  ask(gui::RenameFace{small_.string(), "anna"});
  const fs::path anna = small_.parent_path() / "anna";
  EXPECT_FALSE(model().notice.bad) << model().notice.text;
  EXPECT_EQ(model().faces.shown, anna.string());
  EXPECT_EQ(session_->kept().face, anna.string());
  EXPECT_EQ(assets_->face.name, "anna");
  ask(gui::ShowFace{(assets_->data_folder / "faces" / "marek").string()});
  ask(gui::RenameFace{anna.string(), "berta"});
  EXPECT_EQ(assets_->face.name, "marek") << "another one is shown";
  EXPECT_TRUE(fs::exists(small_.parent_path() / "berta"));
}

TEST_F(WindowSessionFaceTest, InPlaceOfADeletedFaceTheOneIsShownThatItWasMadeOf) {
  ask(gui::CopyFace{(assets_->data_folder / "faces" / "marek").string(), "anna"});
  ask(gui::DeleteFace{model().faces.shown});
  EXPECT_FALSE(model().notice.bad) << model().notice.text;
  EXPECT_EQ(assets_->face.name, "marek");
  EXPECT_EQ(session_->kept().face, "marek") << "the next start finds it";
  EXPECT_FALSE(fs::exists(small_.parent_path() / "anna"));
  ask(gui::ShowFace{small_.string()});
  ask(gui::DeleteFace{small_.string()});
  EXPECT_EQ(assets_->face.name, "default") << "that one was made of no shipped face";
}

TEST_F(WindowSessionFaceTest, AFaceThatIsNotShownIsDeletedBehindIt) {
  ask(gui::DeleteFace{small_.string()});
  EXPECT_FALSE(fs::exists(small_));
  EXPECT_EQ(session_->faces().changes(), 0U);
  const auto& faces = *model().faces.entries;
  EXPECT_TRUE(std::none_of(faces.begin(), faces.end(),
                           [](const auto& one) { return one.kind == gui::FaceKind::Own; }));
}

TEST_F(WindowSessionFaceTest, OnlyOnesOwnFacesAreRenamedAndDeleted) {
  const fs::path marek = assets_->data_folder / "faces" / "marek";
  for (const fs::path& folder : {marek, made_.path(), home_.path()}) {
    ask(gui::RenameFace{folder.string(), "anna"});
    EXPECT_NE(model().notice.text.find("is not one of your own faces"), std::string::npos)
        << model().notice.text;
    ask(gui::CloseNotice{});
    ask(gui::DeleteFace{folder.string()});
    EXPECT_NE(model().notice.text.find("is not one of your own faces"), std::string::npos)
        << model().notice.text;
    EXPECT_TRUE(fs::exists(folder));
  }
  EXPECT_EQ(session_->faces().changes(), 0U);
}

TEST_F(WindowSessionFaceTest, AFaceThatAnotherProgramTookAwayIsNotDeleted) {
  ask(gui::ShowFace{small_.string()});
  fs::rename(small_, home_.path() / "elsewhere");
  ask(gui::DeleteFace{small_.string()});
  EXPECT_NE(model().notice.text.find("cannot be deleted"), std::string::npos)
      << model().notice.text;
  EXPECT_EQ(assets_->face.name, "default") << "there is nothing to go back to";
}

TEST_F(WindowSessionFaceTest, ShippedFacesInThePlaceOfOnesOwnAreNotForDeleting) {
  fs::remove_all(home_.path() / "aucast" / "faces");
  fs::create_directory_symlink(fs::absolute(assets_->data_folder / "faces"),
                               home_.path() / "aucast" / "faces");
  session_.emplace(*assets_, options_, nullptr, stats_);
  const auto& faces = *model().faces.entries;
  EXPECT_TRUE(std::all_of(faces.begin(), faces.end(),
                          [](const auto& one) { return one.kind == gui::FaceKind::Shipped; }));
}

TEST_F(WindowSessionFaceTest, ACopyThatCannotBeMadeIsSaidAndNothingIsLost) {
  fs::remove_all(home_.path() / "aucast" / "faces");
  home_.write("aucast/faces", "a file where a folder should be");
  ask(gui::CopyFace{model().faces.shown, "anna"});
  EXPECT_NE(model().notice.text.find("cannot be copied to"), std::string::npos)
      << model().notice.text;
  EXPECT_EQ(session_->faces().changes(), 0U);
}

TEST_F(WindowSessionFaceTest, WhatIsEditedOrComposedStays) {
  ask(gui::ComposeAu{26, 50, 50, false});
  ask(gui::LoadAu{26});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::ShowFace{small_.string()});
  EXPECT_TRUE(model().editor.unsaved);
  EXPECT_EQ(model().editor.au, 26);
  EXPECT_FLOAT_EQ(shown("jaw"), 3.5F);
  ask(gui::Undo{});
  const auto jaw = static_cast<std::size_t>(channel("jaw"));
  EXPECT_FLOAT_EQ(shown("jaw"), assets_->face.recordings.at(26).activation[jaw]) << "this face's";
  ASSERT_EQ(model().composer.aus.size(), 1U);
  ask(gui::ShowComposed{});
  ask(gui::AddKeyframe{});
  EXPECT_EQ(model().composer.rows->size(), 1U);
}

TEST_F(WindowSessionFaceTest, AnExpressionIsTheSameOneOnAnotherFace) {
  ask(gui::ShowAus{"26:50"});
  go_on(Milliseconds(1000));
  ask(gui::ShowFace{small_.string()});
  const auto& recording = assets_->face.recordings.at(26).activation;
  EXPECT_FLOAT_EQ(shown("jaw"), recording[static_cast<std::size_t>(channel("jaw"))] / 2);
}

TEST_F(WindowSessionFaceTest, AFaceThatCannotBeReadIsSaidAndChangesNothing) {
  home_.write("aucast/faces/small/aus.toml", "nonsense");
  ask(gui::ShowFace{small_.string()});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("aus.toml"), std::string::npos) << model().notice.text;
  EXPECT_EQ(session_->faces().changes(), 0U);
  EXPECT_EQ(assets_->face.name, "default");
  EXPECT_EQ(session_->kept().face, "");
}

TEST_F(WindowSessionFaceTest, FacesOfAFolderAreListedAndADroppedOneIsShown) {
  const test::TempFolder folder;
  fs::copy(made_.path(), folder.path() / "anna", fs::copy_options::recursive);
  ask(gui::Browse{gui::Purpose::LookForFaces});
  ask(gui::EnterFolder{folder.path().string()});
  ask(gui::ChooseFile{"."});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_EQ(model().faces.elsewhere, folder.path().string());
  EXPECT_EQ(model().faces.entries->back().name, "anna");
  EXPECT_EQ(model().faces.entries->back().kind, gui::FaceKind::Elsewhere);
  EXPECT_EQ(session_->faces().changes(), 0U);
  ask(gui::OpenStream{(folder.path() / "anna" / "face.toml").string()});
  EXPECT_EQ(model().faces.shown, (folder.path() / "anna").string());
  ask(gui::ShowFace{made_.path().string()});
  ask(gui::Browse{gui::Purpose::PlayStream});
  ask(gui::EnterFolder{(folder.path() / "anna").string()});
  const auto& offered = model().browser.entries;
  EXPECT_TRUE(std::any_of(offered.begin(), offered.end(),
                          [](const gui::FileEntry& one) { return one.name == "face.toml"; }));
  ask(gui::ChooseFile{"face.toml"});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_EQ(model().faces.shown, (folder.path() / "anna").string());
  ask(gui::Browse{gui::Purpose::LookForFaces});
  ask(gui::EnterFolder{home_.path().string()});
  ask(gui::ChooseFile{"."});
  EXPECT_NE(model().browser.problem.find("no face in this folder"), std::string::npos);
}

TEST_F(WindowSessionFaceTest, AGalleryGoesWherePicturesGo) {
  const test::TempFolder folder;
  ask(gui::Browse{gui::Purpose::PictureFolder});
  ask(gui::EnterFolder{folder.path().string()});
  ask(gui::ChooseFile{"."});
  EXPECT_EQ(model().pictures.folder, folder.path().string());
  EXPECT_EQ(model().gallery.settings.folder, (folder.path() / "gallery").string());
  gui::PictureSettings pictures = model().pictures;
  pictures.folder = home_.path().string();
  ask(gui::ChangePictures{pictures});
  EXPECT_EQ(model().gallery.settings.folder, (home_.path() / "gallery").string());
}

TEST_F(WindowSessionFaceTest, AfterSavingTheFaceIsOnesOwnCopy) {
  ask(gui::LoadAu{12});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::SaveAu{12});
  const fs::path copy = home_.path() / "aucast" / "faces" / "default";
  EXPECT_EQ(model().faces.shown, copy.string());
  EXPECT_EQ(session_->kept().face, copy.string());
  EXPECT_EQ(assets_->face.name, "own_default") << "pictures of it are not the shipped face's";
  ask(gui::ShowFace{(assets_->data_folder / "faces" / "default").string()});
  ask(gui::ShowFace{copy.string()});
  ask(gui::LoadAu{12});
  EXPECT_FLOAT_EQ(shown("jaw"), 3.5F) << "what was saved is what is shown";
}

TEST_F(WindowSessionFaceTest, ACopyWithOtherChangesIsWhatIsShownAfterSaving) {
  ask(gui::LoadAu{12});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::SaveAu{12});
  ask(gui::ShowFace{(assets_->data_folder / "faces" / "default").string()});
  ask(gui::LoadAu{6});
  ask(gui::SetChannel{channel("jaw"), 1, false});
  ask(gui::SaveAu{6});
  ask(gui::LoadAu{12});
  EXPECT_FLOAT_EQ(shown("jaw"), 3.5F) << "as the next start would show it";
}

TEST_F(WindowSessionFaceTest, AnAuOfOnesOwnIsNamedDeletedAndBroughtBack) {
  ask(gui::NeutralFace{});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::SaveAu{77});
  EXPECT_TRUE(model().notice.bad) << "FACS has no name for it";
  EXPECT_NE(model().notice.text.find("AU77"), std::string::npos) << model().notice.text;
  EXPECT_EQ(entry_of(model(), 77).number, 0) << "it was not saved";
  ask(gui::SaveAu{77, "yawn"});
  EXPECT_FALSE(model().notice.bad) << model().notice.text;
  EXPECT_EQ(entry_of(model(), 77).name, "yawn");
  EXPECT_TRUE(entry_of(model(), 77).own);
  EXPECT_FALSE(entry_of(model(), 77).shipped);
  EXPECT_FALSE(entry_of(model(), 12).own);
  ask(gui::SaveAu{77, "big yawn"});
  EXPECT_EQ(entry_of(model(), 77).name, "big yawn") << "saving names it anew";
  ask(gui::RemoveAu{77});
  EXPECT_EQ(entry_of(model(), 77).number, 0);
  EXPECT_EQ(shown("jaw"), 0);
  const fs::path copy = home_.path() / "aucast" / "faces" / "default";
  EXPECT_FALSE(face::load_face(copy, assets_->data_folder)->recordings.contains(77));
  ask(gui::Undo{});
  EXPECT_FLOAT_EQ(shown("jaw"), 3.5F);
  EXPECT_TRUE(model().editor.unsaved);
  EXPECT_EQ(model().editor.names.at(77), "big yawn");
  ask(gui::SaveAu{77});
  EXPECT_EQ(entry_of(model(), 77).name, "big yawn") << "its name came back with it";
  EXPECT_TRUE(model().editor.names.empty());
}

TEST_F(WindowSessionFaceTest, ANameThatWasTypedIsNotLeftWithoutAQuestion) {
  ask(gui::LoadAu{12});
  EXPECT_FALSE(model().editor.unsaved);
  ask(gui::NameAu{77, " yawn"});
  EXPECT_TRUE(model().editor.unsaved);
  session_->ask_to_leave();
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().asks_to_leave);
  ask(gui::Leave{false});
  ask(gui::LoadAu{6});
  EXPECT_EQ(model().editor.names.at(77), " yawn") << "another AU loses nothing";
  ask(gui::LoadAu{77});
  session_->save(clock_.now());
  EXPECT_EQ(entry_of(model(), 77).name, "yawn");
  EXPECT_FALSE(model().editor.unsaved);
  ask(gui::NameAu{77, "yaw"});
  ask(gui::NameAu{77, "yawn"});
  EXPECT_FALSE(model().editor.unsaved) << "it is as it is saved";
  ask(gui::NameAu{77, "big yawn"});
  ask(gui::RevertAu{});
  EXPECT_FALSE(model().editor.unsaved);
}

TEST_F(WindowSessionFaceTest, WhoLeavesSavesAndThenLeaves) {
  ask(gui::LoadAu{12});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  session_->ask_to_leave();
  ask(gui::Leave{.really = false, .saves = true});
  EXPECT_TRUE(session_->leaving().leaves());
  EXPECT_TRUE(entry_of(model(), 12).own);
}

TEST_F(WindowSessionFaceTest, NobodyLeavesWhenSavingFailsOrAsksForAName) {
  fs::remove_all(home_.path() / "aucast" / "faces");
  home_.write("aucast/faces", "a file where a folder should be");
  ask(gui::LoadAu{12});
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  session_->ask_to_leave();
  ask(gui::Leave{.really = false, .saves = true});
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().notice.bad) << "why is said";
  ask(gui::RevertAu{});
  ask(gui::ComposeAu{26, 50, 50, false});
  ask(gui::AddKeyframe{});
  session_->ask_to_leave();
  ask(gui::Leave{.really = false, .saves = true});
  EXPECT_FALSE(session_->leaving().leaves());
  EXPECT_TRUE(model().browser.open) << "the stream has no file yet";
}

TEST_F(WindowSessionFaceTest, WhatIsSaidOfAusIsSaidInTheNewLanguage) {
  gui::DisplaySettings display;
  display.language = "en";
  ask(gui::ChangeDisplay{display});
  ask(gui::ShowAus{"51,52:40"});
  const auto english = model().editor.compound;
  ASSERT_EQ(english.size(), 2U);
  display.language = "fr";
  ask(gui::ChangeDisplay{display});
  const auto french = model().editor.compound;
  ASSERT_EQ(french.size(), 2U);
  EXPECT_NE(french[0].name, english[0].name);
  EXPECT_NE(french[1].why, english[1].why);
  EXPECT_EQ(french[0].shown_percent, english[0].shown_percent);
  gui::use_english();
}

TEST_F(WindowSessionFaceTest, APictureOfTheEditorIsNamedAfterWhatIsEdited) {
  const auto name = [this] {
    const auto file = new_picture();
    return file ? file->stem().string() : file.error().message;
  };
  gui::PictureSettings pictures;
  pictures.folder = home_.path().string();
  pictures.pattern = "{aus}";
  ask(gui::ChangePictures{pictures});
  ask(gui::LoadAu{12});
  EXPECT_EQ(name(), "au12");
  ASSERT_TRUE(session_->face().aus().has_value());
  EXPECT_EQ(session_->face().aus()->left[12], 1);
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  EXPECT_EQ(name(), "au12_edited");
  EXPECT_EQ(session_->face().edited(), "au12_edited");
  EXPECT_FALSE(session_->face().aus().has_value()) << "it is no AU 12 any more";
}

TEST_F(WindowSessionFaceTest, NoPictureIsSavedUnderANameThatIsHalfTyped) {
  gui::PictureSettings pictures;
  pictures.folder = home_.path().string();
  pictures.pattern = "lesson-{numb";
  ask(gui::ChangePictures{pictures});
  EXPECT_EQ(model().pictures.pattern, "lesson-{numb") << "it may be typed on";
  EXPECT_FALSE(new_picture().has_value());
  EXPECT_EQ(session_->kept().pictures.pattern, gui::PictureSettings().pattern);
  pictures.pattern = "lesson-{number}";
  ask(gui::ChangePictures{pictures});
  EXPECT_EQ(session_->kept().pictures.pattern, "lesson-{number}");
  ASSERT_TRUE(new_picture().has_value());
  EXPECT_EQ(new_picture()->filename(), "lesson-1.png");
}

TEST_F(WindowSessionFaceTest, AnAuThatCameWithTheFaceIsAsItCameAgain) {
  ask(gui::LoadAu{12});
  const float jaw = shown("jaw");
  ask(gui::RemoveAu{12});
  EXPECT_EQ(entry_of(model(), 12).number, 12) << "it is not one's own";
  ask(gui::SetChannel{channel("jaw"), 3.5F, false});
  ask(gui::SaveAu{12});
  EXPECT_TRUE(entry_of(model(), 12).own);
  ask(gui::RemoveAu{12});
  EXPECT_FALSE(entry_of(model(), 12).own);
  EXPECT_FLOAT_EQ(shown("jaw"), jaw);
}

TEST_F(WindowSessionFaceTest, AGalleryIsOfTheFaceThatIsShown) {
  const test::TempFolder folder;
  gui::GallerySettings settings;
  settings.folder = (folder.path() / "gallery").string();
  settings.sections = {};
  settings.sections[5] = true;  // which AUs there are: no picture is drawn for it
  ask(gui::ShowFace{small_.string()});
  ask(gui::GalleryCommand(gui::ChangeGallery{settings}));
  ask(gui::GalleryCommand(gui::BeginGallery{}));
  while (model().gallery.running) session_->advance(clock_.now());
  const gui::GalleryView& gallery = model().gallery;
  if (gallery.failed) {
    // A build without OpenGL, and a computer without, can draw none.
    EXPECT_NE(gallery.outcome.find("GL"), std::string::npos) << gallery.outcome;
    return;
  }
  EXPECT_NE(folder.read("gallery/index.html").find("small"), std::string::npos);
}

TEST_F(WindowSessionFaceTest, AnAuIsExportedAsAFileOfAus) {
  const test::TempFolder folder;
  ask(gui::LoadAu{26});
  ask(gui::Browse{gui::Purpose::ExportAu});
  EXPECT_EQ(model().browser.name, "au26.toml");
  ask(gui::EnterFolder{folder.path().string()});
  ask(gui::ChooseFile{"au26.toml"});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_EQ(folder.read("au26.toml").find("[[au]]\nnumber = 26\ndrive = { "), 0U)
      << folder.read("au26.toml");
}

TEST_F(WindowSessionFaceTest, AusOfAFileBecomeOnesOwn) {
  const test::TempFolder folder;
  const auto file = folder.write("two.toml",
                                 "[[au]]\nnumber = 12\ndrive = { jaw = 2.5 }\n\n"
                                 "[[au]]\nnumber = 77\nnote = \"yawn\"\ndrive = { jaw = 3.5 }\n");
  ask(gui::LoadAu{12});
  ask(gui::Browse{gui::Purpose::ImportAus});
  ask(gui::ChooseFile{file.string()});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_EQ(model().notice.text.find("AU 12, 77 imported into "), 0U) << model().notice.text;
  EXPECT_TRUE(model().editor.active);
  EXPECT_EQ(model().editor.au, 12);
  EXPECT_FALSE(model().editor.unsaved);
  EXPECT_FLOAT_EQ(shown("jaw"), 2.5F);
  EXPECT_TRUE(entry_of(model(), 12).own);
  EXPECT_EQ(entry_of(model(), 77).name, "yawn");
  const fs::path copy = home_.path() / "aucast" / "faces" / "default";
  EXPECT_EQ(model().faces.shown, copy.string());
  EXPECT_EQ(session_->kept().face, copy.string()) << "the next start shows it";
  const auto saved = face::load_face(copy, assets_->data_folder);
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->recordings.at(77).note, "yawn");
  ask(gui::Undo{});
  EXPECT_TRUE(model().editor.unsaved) << "what was there is now a change";
}

TEST_F(WindowSessionFaceTest, AFileOfAusThatIsNoneIsRefusedWhole) {
  const test::TempFolder folder;
  const auto refused = [&](const std::string& text) {
    ask(gui::Browse{gui::Purpose::ImportAus});
    ask(gui::ChooseFile{folder.write("aus.toml", text).string()});
    EXPECT_TRUE(model().browser.open);
    const std::string problem = model().browser.problem;
    ask(gui::CloseBrowser{});
    return problem;
  };
  const std::string known = "[[au]]\nnumber = 77\ndrive = { jaw = 3.5 }\n";
  EXPECT_NE(refused(known + "[[au]]\nnumber = 78\ndrive = { wing = 1 }\n").find("aus.toml:6:"),
            std::string::npos);
  EXPECT_NE(refused("[[au]]\nnumber = 0\ndrive = { jaw = 1 }\n").find("no AU in this file"),
            std::string::npos);
  EXPECT_NE(refused("Beg_Stream\n").find("aus.toml:1:"), std::string::npos);
  EXPECT_EQ(entry_of(model(), 77).number, 0);
  EXPECT_FALSE(fs::exists(home_.path() / "aucast" / "faces" / "default"));
}

TEST_F(WindowSessionFaceTest, AThumbnailIsOfTheFaceAsItWouldBeShown) {
  const std::size_t jaw = *assets_->face.channel_index("jaw");
  const float open = session_->composer().face_of("27").at(jaw);
  EXPECT_GT(open, 0);
  EXPECT_FLOAT_EQ(session_->composer().face_of("27:50").at(jaw), open / 2);
  ask(gui::SetChannel{static_cast<int>(jaw), 0.5F, false});
  ask(gui::SaveAu{27});
  EXPECT_FLOAT_EQ(session_->composer().face_of("27").at(jaw), 0.5F) << "as it is recorded now";
}

}  // namespace
}  // namespace aucast::app
