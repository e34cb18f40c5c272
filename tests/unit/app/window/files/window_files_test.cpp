#include "client/app/window/files/window_files.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/gui/texts/texts.h"
#include "tests/support/manual_clock.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::app {
namespace {

using gui::Purpose;

/// On a face without any channel, which is not shown anywhere.
class WindowFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    assets_.data_folder = folder_.path();
    assets_.face_folder = folder_.path() / "faces" / "none";
    files_.emplace(assets_, std::filesystem::path(),
                   WindowFiles::Users{playback_, editor_, composer_, faces_, gallery_, exports_,
                                      onsets_, mirror_, notices_},
                   hooks());
  }
  WindowFiles::Hooks hooks() {
    return {.show_face = [this](const std::filesystem::path& folder, Instant) -> Result<void> {
              face_ = folder;
              return {};
            },
            .show = [this](Shown shown, Instant) { shown_ = shown; },
            .show_saved_face = [](Instant) {},
            .put_pictures_in = [this](const std::filesystem::path& folder) { pictures_ = folder; },
            .named =
                [this] {
                  Named named;
                  named.stream = files_->name_of_stream(true);
                  return named;
                },
            .options_as_shown = [] { return PlayerOptions(); },
            .activations = [this]() -> const std::vector<float>& { return activations_; }};
  }
  void ask(const gui::FileCommand& command) { files_->apply(command, clock_.now()); }
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
  test::ManualClock clock_;
  Assets assets_;
  PlayerOptions options_;
  PlayerStats stats_;
  Notices notices_;
  std::vector<float> activations_;
  pipeline::AuMapping mapping_{assets_.face, {}, {}};
  PlaybackSession playback_{mapping_, options_, stats_, notices_, activations_};
  EditorSession editor_{assets_, mapping_, notices_, activations_};
  ComposerSession composer_{assets_, mapping_};
  FaceSession faces_{assets_};
  GallerySession gallery_{{}, {}};
  ExportSession exports_{{}};
  OnsetSession onsets_;
  MirrorSession mirror_{{}};
  std::filesystem::path face_;
  std::filesystem::path pictures_;
  std::optional<Shown> shown_;
  std::optional<WindowFiles> files_;
};

TEST_F(WindowFilesTest, AStreamThatIsChosenPlaysAndIsRemembered) {
  const std::filesystem::path file = stream();
  choose(Purpose::PlayStream, file);
  EXPECT_FALSE(files_->browser().open);
  EXPECT_EQ(shown_, Shown::Playback);
  EXPECT_EQ(playback_.local_view().name, "two.txt");
  EXPECT_EQ(files_->name_of_stream(false), "two");
  EXPECT_EQ(files_->recent(), std::vector<std::string>{file.string()});
}

TEST_F(WindowFilesTest, WhatCannotBePlayedIsSaidWhereTheUserLooks) {
  ask(gui::OpenStream{"/no/such/stream.txt"});
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_NE(notices_.view().text.find("/no/such/stream.txt"), std::string::npos);
  notices_.clear();
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::OpenStream{"/no/such/stream.txt"});
  EXPECT_TRUE(files_->browser().open);
  EXPECT_NE(files_->browser().problem.find("/no/such/stream.txt"), std::string::npos);
  EXPECT_EQ(notices_.view().text, "");
  EXPECT_EQ(shown_, std::nullopt);
}

TEST_F(WindowFilesTest, AFilmIsNoStream) {
  ask(gui::OpenStream{folder_.write("me.mp4", "").string()});
  EXPECT_EQ(notices_.view().text, gui::tr("said.is_film", "me.mp4"));
}

TEST_F(WindowFilesTest, AFaceThatIsOpenedIsShown) {
  ask(gui::OpenStream{folder_.write("face.toml", "").string()});
  EXPECT_EQ(face_, folder_.path());
  EXPECT_FALSE(playback_.local_view().open);
}

TEST_F(WindowFilesTest, HowATableIsReadIsAskedAnewForEachDialog) {
  gui::TableSettings settings;
  settings.gain_percent = 150;
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::ChangeTable{settings});
  EXPECT_TRUE(files_->tables().asked.has_value());
  ask(gui::CloseBrowser{});
  ask(gui::Browse{Purpose::PlayStream});
  EXPECT_FALSE(files_->tables().asked.has_value());
}

TEST_F(WindowFilesTest, WhatIsWrongWithATableIsOverWhenItIsReadInAnotherWay) {
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::ChooseFile{folder_.write("empty.csv", "").string()});
  EXPECT_NE(files_->browser().problem, "");
  ask(gui::ChangeTable{{.fps = 30}});
  EXPECT_EQ(files_->browser().problem, "");
  EXPECT_TRUE(files_->browser().open);
}

TEST_F(WindowFilesTest, AStreamIsComposedFromAFileAndSavedThereAgain) {
  choose(Purpose::ComposeStream, stream());
  EXPECT_EQ(shown_, Shown::Composer);
  files_->save_composition(clock_.now());
  EXPECT_FALSE(files_->browser().open);
  EXPECT_FALSE(notices_.view().bad) << notices_.view().text;
}

TEST_F(WindowFilesTest, ACompositionWithoutAFileIsAskedForOne) {
  files_->save_composition(clock_.now());
  EXPECT_TRUE(files_->browser().open);
  EXPECT_EQ(files_->browser().name, kComposedName);
}

TEST_F(WindowFilesTest, NothingPlayedCannotBeExported) {
  ask(gui::Browse{Purpose::ExportTable});
  ask(gui::EnterFolder{folder_.path().string()});
  ask(gui::ChooseFile{"table.csv"});
  EXPECT_TRUE(files_->browser().open);
  EXPECT_FALSE(files_->browser().problem.empty());
}

TEST_F(WindowFilesTest, AFolderIsTakenForWhatItWasAskedFor) {
  choose_folder(Purpose::PictureFolder);
  EXPECT_EQ(pictures_, folder_.path());
  choose_folder(Purpose::GalleryFolder);
  EXPECT_EQ(gallery_.view().settings.folder, folder_.path().string());
  choose_folder(Purpose::LookForFaces);
  EXPECT_EQ(files_->browser().problem, gui::tr("said.no_face"));
}

TEST_F(WindowFilesTest, AFilmIsWhatTheCameraOpensNext) {
  const std::filesystem::path film = folder_.write("me.mp4", "");
  choose(Purpose::CameraFilm, film);
  EXPECT_EQ(mirror_.view().source, "camera:" + film.string());
}

TEST_F(WindowFilesTest, WhatTheNextConnectionNeedsIsChosenWhereItLies) {
  const std::filesystem::path token = folder_.write("token", "secret");
  choose(Purpose::TokenFile, token);
  EXPECT_FALSE(files_->browser().open) << files_->browser().problem;
  EXPECT_EQ(files_->credentials().token, token.string());
  ask(gui::Browse{Purpose::AuthoritiesFile});
  EXPECT_EQ(files_->browser().folder, folder_.path().string());
  EXPECT_EQ(files_->credentials().token, "") << "chosen again, it is put into its field again";
  ask(gui::CloseBrowser{});
  ask(gui::Browse{Purpose::ExportMesh});
  EXPECT_NE(files_->browser().folder, folder_.path().string()) << "no place for what is made";
}

TEST_F(WindowFilesTest, AFolderIsSearchedForFacesOrIsOne) {
  folder_.write("people/anna/face.toml", "");
  const std::filesystem::path people = folder_.path() / "people";
  ask(gui::Browse{Purpose::LookForFaces});
  ask(gui::EnterFolder{people.string()});
  ask(gui::ChooseFile{"."});
  EXPECT_FALSE(files_->browser().open);
  EXPECT_EQ(faces_.view().elsewhere, people.string());
  EXPECT_EQ(face_, "") << "they are listed, none is shown";
  ask(gui::Browse{Purpose::LookForFaces});
  ask(gui::EnterFolder{(people / "anna").string()});
  ask(gui::ChooseFile{"."});
  EXPECT_EQ(face_, people / "anna");
}

TEST_F(WindowFilesTest, WhatPlayedIsExportedUnderTheNameThatIsSuggested) {
  choose(Purpose::PlayStream, stream());
  ask(gui::Browse{Purpose::ExportKeyframes});
  EXPECT_EQ(files_->browser().name, "two_played.txt");
  const std::filesystem::path out = folder_.path() / "out.txt";
  ask(gui::ChooseFile{out.string()});
  EXPECT_FALSE(files_->browser().open) << files_->browser().problem;
  EXPECT_NE(notices_.view().text.find(out.string()), std::string::npos) << notices_.view().text;
  EXPECT_NE(folder_.read("out.txt").find("26;100"), std::string::npos);
}

TEST_F(WindowFilesTest, OnsetsAreLoggedWhereItWasChosen) {
  const std::filesystem::path out = folder_.path() / "onsets.csv";
  choose(Purpose::LogOnsets, out);
  EXPECT_EQ(onsets_.file(), out.string());
  EXPECT_EQ(notices_.view().text, gui::tr("said.onsets_begun", out.string()));
}

TEST_F(WindowFilesTest, ASoundNeedsAStreamToGoWith) {
  ask(gui::OpenStream{folder_.write("voice.wav", "").string()});
  EXPECT_TRUE(notices_.view().bad);
  EXPECT_EQ(notices_.view().text, gui::tr("said.sound_alone", "voice.wav"));
}

TEST_F(WindowFilesTest, AusThatCannotBeImportedShowNothing) {
  choose(Purpose::ImportAus, folder_.write("aus.toml", "nothing"));
  EXPECT_TRUE(files_->browser().open);
  EXPECT_FALSE(files_->browser().problem.empty());
  EXPECT_EQ(shown_, std::nullopt);
}

TEST_F(WindowFilesTest, HowATableWasReadIsSaidAndKnownTheNextTime) {
  const std::filesystem::path table = folder_.write("table.csv", sources::tables::kOpenFace1);
  gui::TableSettings settings;
  settings.gain_percent = 150;
  ask(gui::Browse{Purpose::PlayStream});
  ask(gui::ChangeTable{settings});
  ask(gui::ChooseFile{table.string()});
  EXPECT_EQ(shown_, Shown::Playback) << files_->browser().problem;
  EXPECT_NE(notices_.view().text.find("OpenFace 1"), std::string::npos) << notices_.view().text;
  ask(gui::OpenStream{table.string()});
  ASSERT_EQ(files_->tables().known->size(), 1U);
  EXPECT_EQ(files_->tables().known->front(), (gui::KnownTable{table.string(), settings}));
}

TEST_F(WindowFilesTest, WhatIsKeptBeginsTheSameWay) {
  gui::KeptSettings kept;
  kept.recent_files = {"/a.txt", "/b.txt"};
  kept.tables = {{"/a.csv", {}}};
  files_->begin_with(kept);
  gui::KeptSettings again;
  files_->keep(again);
  EXPECT_EQ(again.recent_files, kept.recent_files);
  EXPECT_EQ(again.tables, kept.tables);
}

}  // namespace
}  // namespace aucast::app
