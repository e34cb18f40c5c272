#include "client/app/window/files/file_session.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/home_variable.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

using gui::Purpose;

/// Folders for streams, and for what the user makes.
class FileSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("streams/talk.txt", "");
    folder_.write("lectures/one.txt", "");
    folder_.write("made/table.csv", "");
  }
  [[nodiscard]] std::string in(const char* name) const { return folder_.path() / name; }
  [[nodiscard]] const gui::BrowserView& view() const { return session_.view(); }
  [[nodiscard]] static gui::KeptSettings kept_by(const FileSession& session) {
    gui::KeptSettings kept;
    session.keep(kept);
    return kept;
  }
  /// Uses every file, and notes it.
  std::string choose(const std::string& name) {
    return session_.choose(name, [this](Purpose, const std::filesystem::path& file) {
      used_.push_back(file.string());
      return Result<std::string>("used");
    });
  }

  test::TempFolder folder_;
  FileSession session_{folder_.path() / "streams"};
  std::vector<std::string> used_;
};

TEST_F(FileSessionTest, ComesAgainInTheFolderThatWasLeft) {
  session_.browse(Purpose::PlayStream, "");
  EXPECT_EQ(view().folder, in("streams"));
  session_.enter(in("lectures"));
  session_.close();
  session_.browse(Purpose::ComposeStream, "");
  EXPECT_EQ(view().folder, in("lectures")) << "streams are looked for in one place";
}

TEST_F(FileSessionTest, TheFolderOfWhatWasSavedIsKeptForTheNextStart) {
  session_.browse(Purpose::ExportTable, "two.csv");
  session_.enter(in("lectures"));
  session_.close();
  EXPECT_EQ(kept_by(session_).own_folder, "") << "nothing was saved there";
  session_.browse(Purpose::ExportTable, "two.csv");
  EXPECT_EQ(choose(in("made") + "/two.csv"), "used");
  EXPECT_EQ(kept_by(session_).own_folder, in("made"));
  FileSession next{folder_.path() / "streams"};
  next.begin_with(kept_by(session_));
  next.browse(Purpose::ExportMesh, "two.obj");
  EXPECT_EQ(next.view().folder, in("made"));
  EXPECT_EQ(kept_by(next).own_folder, in("made"));
  FileSession later{folder_.path() / "streams"};
  gui::KeptSettings gone;
  gone.own_folder = in("gone");
  later.begin_with(gone);
  later.browse(Purpose::ExportMesh, "two.obj");
  EXPECT_NE(later.view().folder, in("gone"));
}

TEST_F(FileSessionTest, WhereFacesLieIsNoPlaceForStreamsAndExports) {
  folder_.write("faces/anna/face.toml", "");
  session_.browse(Purpose::ExportAu, "au12.toml");
  session_.enter(in("made"));
  session_.close();
  session_.browse(Purpose::LookForFaces, "", in("faces"));
  session_.close();
  session_.browse(Purpose::ExportAu, "au12.toml");
  EXPECT_EQ(view().folder, in("made"));
  session_.close();
  session_.browse(Purpose::PlayStream, "");
  EXPECT_EQ(choose(in("faces") + "/anna/face.toml"), "used");
  session_.browse(Purpose::PlayStream, "");
  EXPECT_EQ(view().folder, in("streams"));
}

TEST_F(FileSessionTest, WhatTheUserMakesHasAFolderOfItsOwn) {
  session_.browse(Purpose::ExportTable, "two.csv");
  EXPECT_EQ(view().name, "two.csv");
  EXPECT_EQ(choose(in("made") + "/two.csv"), "used");
  EXPECT_EQ(used_, std::vector{in("made") + "/two.csv"});
  EXPECT_FALSE(view().open);
  session_.browse(Purpose::ExportMesh, "two.obj");
  EXPECT_EQ(view().folder, in("made"));
  session_.close();
  session_.browse(Purpose::PlayStream, "");
  EXPECT_EQ(view().folder, in("streams"));
  EXPECT_EQ(view().name, "") << "a file that is opened has its name already";
}

TEST_F(FileSessionTest, StaysOpenAndSaysWhyAFileCannotBeUsed) {
  session_.browse(Purpose::PlayStream, "");
  const std::string said = session_.choose("talk.txt", [](Purpose, const std::filesystem::path&) {
    return Result<std::string>(Error{ErrorKind::BadData, "no stream"});
  });
  EXPECT_EQ(said, "");
  EXPECT_TRUE(view().open);
  EXPECT_EQ(view().problem, "no stream");
}

TEST_F(FileSessionTest, UsesNothingWhileItIsClosed) {
  EXPECT_EQ(choose("talk.txt"), "");
  EXPECT_TRUE(used_.empty());
  EXPECT_FALSE(session_.refuse("no stream")) << "that is to be said elsewhere";
}

TEST_F(FileSessionTest, StreamsThatWereOpenedAreRememberedTheNewestFirst) {
  session_.opened(in("streams") + "/talk.txt");
  session_.opened(in("lectures") + "/one.txt");
  session_.opened(in("streams") + "/talk.txt");
  EXPECT_EQ(session_.recent(),
            (std::vector{in("streams") + "/talk.txt", in("lectures") + "/one.txt"}));
}

TEST_F(FileSessionTest, ATildeThatIsTypedIsTheHomeFolder) {
  const test::HomeVariable home;
  home.folder().write("lara.csv", "");
  session_.browse(Purpose::PlayStream, "");
  EXPECT_EQ(choose("~"), "");
  EXPECT_EQ(view().folder, home.folder().path());
  session_.enter(in("lectures"));
  EXPECT_EQ(choose("~/"), "");
  EXPECT_EQ(view().folder, home.folder().path());
  session_.enter(in("lectures"));
  EXPECT_EQ(choose("~/lara.csv"), "used");
  session_.browse(Purpose::ExportAu, "au90.toml");
  session_.enter(in("made"));
  EXPECT_EQ(choose("~/au90"), "used");
  EXPECT_EQ(used_, (std::vector{home.in("lara.csv"), home.in("au90.toml")}));
}

TEST_F(FileSessionTest, AFolderThatIsCalledATildeIsReachedFromTheOneAround) {
  const test::HomeVariable home;
  folder_.write("made/~/table.csv", "");
  session_.browse(Purpose::ExportMesh, "two.obj");
  session_.enter(in("made"));
  EXPECT_EQ(choose("./~"), "");
  EXPECT_EQ(view().folder, in("made/~"));
}

}  // namespace
}  // namespace aucast::app
