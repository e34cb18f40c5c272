#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/gui/texts/texts.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"
#include "tests/unit/sources/tables.h"

namespace aucast::app {
namespace {

using gui::Purpose;

class WindowSessionFilesTest : public SessionOnDefaultFace {
 protected:
  void SetUp() override { session_.emplace(*assets_, options_, nullptr, stats_); }
  void ask(const gui::GuiCommand& command) { session_->apply(command, clock_.now()); }
  /// Opens the dialog and chooses what is there.
  void choose(Purpose purpose, const std::filesystem::path& file) {
    ask(gui::Browse{purpose});
    ask(gui::ChooseFile{file.string()});
  }
  /// The same with the folder of the test.
  void choose_folder(Purpose purpose) {
    ask(gui::Browse{purpose});
    ask(gui::EnterFolder{folder_.path().string()});
    ask(gui::ChooseFile{"."});
  }
  [[nodiscard]] std::filesystem::path stream() {
    return folder_.write("two.txt", "Beg_Stream\n26;100\n0;200\nEnd_Stream\n");
  }

  test::TempFolder folder_;
};

TEST_F(WindowSessionFilesTest, AStreamThatIsChosenPlaysAndIsRemembered) {
  const std::filesystem::path file = stream();
  choose(Purpose::PlayStream, file);
  EXPECT_FALSE(model().browser.open);
  EXPECT_EQ(model().local.name, "two.txt");
  EXPECT_EQ(model().recent_files, std::vector<std::string>{file.string()});
}

TEST_F(WindowSessionFilesTest, WhatCannotBePlayedIsSaidWhereTheUserLooks) {
  ask(gui::OpenStream{"/no/such/stream.txt"});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_NE(model().notice.text.find("/no/such/stream.txt"), std::string::npos);
  ask(gui::CloseNotice{});
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::OpenStream{"/no/such/stream.txt"});
  EXPECT_TRUE(model().browser.open);
  EXPECT_NE(model().browser.problem.find("/no/such/stream.txt"), std::string::npos);
  EXPECT_EQ(model().notice.text, "");
  EXPECT_FALSE(model().editor.active);
}

TEST_F(WindowSessionFilesTest, AFilmIsNoStream) {
  ask(gui::OpenStream{folder_.write("me.mp4", "").string()});
  EXPECT_EQ(model().notice.text, gui::tr("said.is_film", "me.mp4"));
}

TEST_F(WindowSessionFilesTest, HowATableIsReadIsAskedAnewForEachDialog) {
  gui::TableSettings settings;
  settings.gain_percent = 150;
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::ChangeTable{settings});
  EXPECT_TRUE(model().tables.asked.has_value());
  ask(gui::CloseBrowser{});
  ask(gui::Browse{Purpose::PlayStream});
  EXPECT_FALSE(model().tables.asked.has_value());
}

TEST_F(WindowSessionFilesTest, WhatIsWrongWithATableIsOverWhenItIsReadInAnotherWay) {
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::ChooseFile{folder_.write("empty.csv", "").string()});
  EXPECT_NE(model().browser.problem, "");
  ask(gui::ChangeTable{{.fps = 30}});
  EXPECT_EQ(model().browser.problem, "");
  EXPECT_TRUE(model().browser.open);
}

TEST_F(WindowSessionFilesTest, AStreamIsComposedFromAFileAndSavedThereAgain) {
  choose(Purpose::ComposeStream, stream());
  EXPECT_TRUE(model().composer.active);
  ask(gui::ComposerCommand(gui::SaveComposition{}));
  EXPECT_FALSE(model().browser.open);
  EXPECT_FALSE(model().notice.bad) << model().notice.text;
}

TEST_F(WindowSessionFilesTest, NothingPlayedCannotBeExported) {
  ask(gui::Browse{Purpose::ExportTable});
  ask(gui::EnterFolder{folder_.path().string()});
  ask(gui::ChooseFile{"table.csv"});
  EXPECT_TRUE(model().browser.open);
  EXPECT_FALSE(model().browser.problem.empty());
}

TEST_F(WindowSessionFilesTest, AFolderIsTakenForWhatItWasAskedFor) {
  choose_folder(Purpose::PictureFolder);
  EXPECT_EQ(model().pictures.folder, folder_.path().string());
  choose_folder(Purpose::GalleryFolder);
  EXPECT_EQ(model().gallery.settings.folder, folder_.path().string());
  choose_folder(Purpose::LookForFaces);
  EXPECT_EQ(model().browser.problem, gui::tr("said.no_face"));
}

TEST_F(WindowSessionFilesTest, AFolderThatIsAFaceIsShown) {
  ask(gui::Browse{Purpose::LookForFaces});
  ask(gui::EnterFolder{assets_->face_folder.string()});
  ask(gui::ChooseFile{"."});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_EQ(session_->faces().changes(), 1U);
}

TEST_F(WindowSessionFilesTest, AFilmIsWhatTheCameraOpensNext) {
  const std::filesystem::path film = folder_.write("me.mp4", "");
  choose(Purpose::CameraFilm, film);
  EXPECT_EQ(model().mirror.source, "camera:" + film.string());
}

TEST_F(WindowSessionFilesTest, WhatTheNextConnectionNeedsIsChosenWhereItLies) {
  const std::filesystem::path token = folder_.write("token", "secret");
  choose(Purpose::TokenFile, token);
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_EQ(model().credentials.token, token.string());
  ask(gui::Browse{Purpose::AuthoritiesFile});
  EXPECT_EQ(model().browser.folder, folder_.path().string());
  EXPECT_EQ(model().credentials.token, "") << "chosen again, it is put into its field again";
  ask(gui::CloseBrowser{});
  ask(gui::Browse{Purpose::ExportMesh});
  EXPECT_NE(model().browser.folder, folder_.path().string()) << "no place for what is made";
}

TEST_F(WindowSessionFilesTest, WhatPlayedIsExportedUnderTheNameThatIsSuggested) {
  choose(Purpose::PlayStream, stream());
  ask(gui::Browse{Purpose::ExportKeyframes});
  EXPECT_EQ(model().browser.name, "two_played.txt");
  const std::filesystem::path out = folder_.path() / "out.txt";
  ask(gui::ChooseFile{out.string()});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_NE(model().notice.text.find(out.string()), std::string::npos) << model().notice.text;
  EXPECT_NE(folder_.read("out.txt").find("26;100"), std::string::npos);
}

TEST_F(WindowSessionFilesTest, OnsetsAreLoggedWhereItWasChosen) {
  const std::filesystem::path out = folder_.path() / "onsets.csv";
  choose(Purpose::LogOnsets, out);
  EXPECT_EQ(model().onsets, out.string());
  EXPECT_EQ(model().notice.text, gui::tr("said.onsets_begun", out.string()));
}

TEST_F(WindowSessionFilesTest, ASoundNeedsAStreamToGoWith) {
  ask(gui::OpenStream{folder_.write("voice.wav", "").string()});
  EXPECT_TRUE(model().notice.bad);
  EXPECT_EQ(model().notice.text, gui::tr("said.sound_alone", "voice.wav"));
}

TEST_F(WindowSessionFilesTest, AusThatCannotBeImportedShowNothing) {
  choose(Purpose::ImportAus, folder_.write("aus.toml", "nothing"));
  EXPECT_TRUE(model().browser.open);
  EXPECT_FALSE(model().browser.problem.empty());
  EXPECT_FALSE(model().editor.active);
}

TEST_F(WindowSessionFilesTest, HowATableWasReadIsSaidAndKnownTheNextTime) {
  const std::filesystem::path table = folder_.write("table.csv", sources::tables::kOpenFace1);
  gui::TableSettings settings;
  settings.gain_percent = 150;
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::ChangeTable{settings});
  ask(gui::ChooseFile{table.string()});
  EXPECT_FALSE(model().browser.open) << model().browser.problem;
  EXPECT_NE(model().notice.text.find("OpenFace 1"), std::string::npos) << model().notice.text;
  ask(gui::OpenStream{table.string()});
  ASSERT_EQ(model().tables.known->size(), 1U);
  EXPECT_EQ(model().tables.known->front(), (gui::KnownTable{table.string(), settings}));
}

TEST_F(WindowSessionFilesTest, WhatIsKeptBeginsTheSameWay) {
  gui::KeptSettings kept;
  kept.recent_files = {"/a.txt", "/b.txt"};
  kept.tables = {{"/a.csv", {}}};
  session_->begin_with(kept, {}, clock_.now());
  const gui::KeptSettings again = session_->kept();
  EXPECT_EQ(again.recent_files, kept.recent_files);
  EXPECT_EQ(again.tables, kept.tables);
}

}  // namespace
}  // namespace aucast::app
