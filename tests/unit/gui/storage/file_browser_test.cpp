#include "client/gui/storage/file_browser.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::gui {
namespace {

namespace fs = std::filesystem;

class FileBrowserTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("b.txt", "");
    folder_.write("a.txt", "");
    folder_.write(".hidden", "");
    fs::create_directory(folder_.path() / "zoo");
  }

  test::TempFolder folder_;
  FileBrowser browser_;
  fs::path chosen_;
};

TEST_F(FileBrowserTest, ListsFoldersFirstAndLeavesHiddenOnesOut) {
  browser_.open(Purpose::PlayStream, folder_.path());
  const std::vector<FileEntry> expected = {{"zoo", true}, {"a.txt", false}, {"b.txt", false}};
  EXPECT_EQ(browser_.view().entries, expected);
  EXPECT_EQ(browser_.view().folder, folder_.path().string());
  browser_.close();
  EXPECT_EQ(browser_.view(), BrowserView());
}

TEST_F(FileBrowserTest, OffersWhatCanBeOpened) {
  for (const char* other : {"README.md", "a.jpg", "a.vtt", "Take.CSV", "aus.toml", "b.opus"}) {
    folder_.write(other, "");
  }
  browser_.open(Purpose::PlayStream, folder_.path());
  const std::vector<FileEntry> played = {
      {"zoo", true}, {"Take.CSV"}, {"a.txt"}, {"b.opus"}, {"b.txt"}};
  EXPECT_EQ(browser_.view().entries, played);
  ASSERT_TRUE(browser_.choose("a.jpg", chosen_)) << "what is typed is meant";
  browser_.open(Purpose::ImportAus, folder_.path());
  const std::vector<FileEntry> imported = {{"zoo", true}, {"aus.toml"}};
  EXPECT_EQ(browser_.view().entries, imported);
  browser_.open(Purpose::SaveStream, folder_.path());
  EXPECT_EQ(browser_.view().entries.size(), 9U) << "what is there would be replaced";
}

TEST_F(FileBrowserTest, DoesNotListWhatSavingHasLeft) {
  for (const char* left : {"a.txt~", "b.txt.part-1804289383"}) folder_.write(left, "");
  browser_.open(Purpose::SaveStream, folder_.path());
  EXPECT_EQ(browser_.view().entries.size(), 3U);
}

TEST_F(FileBrowserTest, ANewFileWithoutAnEndingGetsThatOfItsKind) {
  const auto saved_as = [this](Purpose purpose, const char* typed) {
    browser_.open(purpose, folder_.path());
    return browser_.choose(typed, chosen_) ? chosen_.filename().string() : std::string();
  };
  EXPECT_EQ(saved_as(Purpose::SaveStream, "my talk"), "my talk.txt");
  EXPECT_EQ(saved_as(Purpose::SaveStream, "zoo/my talk"), "my talk.txt");
  EXPECT_EQ(saved_as(Purpose::SaveStream, "my talk.stream"), "my talk.stream");
  EXPECT_EQ(saved_as(Purpose::SaveStream, "zoo"), "") << "that folder is entered";
  EXPECT_EQ(saved_as(Purpose::ExportKeyframes, "x"), "x.txt");
  EXPECT_EQ(saved_as(Purpose::ExportTable, "x"), "x.csv");
  EXPECT_EQ(saved_as(Purpose::LogOnsets, "x"), "x.csv");
  EXPECT_EQ(saved_as(Purpose::ExportMesh, "x"), "x.obj");
  EXPECT_EQ(saved_as(Purpose::ExportGlb, "x"), "x.glb");
  EXPECT_EQ(saved_as(Purpose::ExportAu, "x"), "x.toml");
  EXPECT_EQ(saved_as(Purpose::PlayStream, "x"), "x");
  EXPECT_EQ(saved_as(Purpose::SaveStream, "a"), "") << "a.txt would be replaced";
  EXPECT_EQ(browser_.view().name, "a.txt");
  EXPECT_TRUE(browser_.choose("a.txt", chosen_));
  folder_.write("plain", "");
  EXPECT_EQ(saved_as(Purpose::SaveStream, "plain"), "");
  EXPECT_EQ(browser_.view().replaces, (folder_.path() / "plain").string());
}

TEST_F(FileBrowserTest, OpensTheNearestFolderThatIsThere) {
  browser_.open(Purpose::PlayStream, folder_.path() / "gone" / "deeper");
  EXPECT_EQ(browser_.view().folder, folder_.path().string());
  EXPECT_TRUE(browser_.view().problem.empty());
}

TEST_F(FileBrowserTest, WalksDownAndUp) {
  browser_.open(Purpose::PlayStream, folder_.path());
  browser_.enter("zoo");
  EXPECT_EQ(browser_.view().folder, (folder_.path() / "zoo").string());
  EXPECT_TRUE(browser_.view().entries.empty());
  browser_.enter("..");
  EXPECT_EQ(browser_.view().folder, folder_.path().string());
  browser_.enter("/");
  EXPECT_EQ(browser_.view().folder, "/");
}

TEST_F(FileBrowserTest, AFolderThatCannotBeReadIsSaid) {
  browser_.open(Purpose::PlayStream, folder_.path());
  browser_.enter("gone");
  EXPECT_EQ(browser_.view().folder, folder_.path().string());
  EXPECT_NE(browser_.view().problem.find("gone: No such file"), std::string::npos);
  EXPECT_EQ(browser_.view().entries.size(), 3U);
}

TEST_F(FileBrowserTest, ChoosesAFileByNameOrByItsWholePath) {
  browser_.open(Purpose::PlayStream, "/");
  ASSERT_TRUE(browser_.choose(folder_.path() / "a.txt", chosen_));
  EXPECT_EQ(chosen_, folder_.path() / "a.txt");
  browser_.enter(folder_.path());
  ASSERT_TRUE(browser_.choose("b.txt", chosen_));
  EXPECT_EQ(chosen_, folder_.path() / "b.txt");
  EXPECT_FALSE(browser_.choose("zoo", chosen_));
  EXPECT_EQ(browser_.view().folder, (folder_.path() / "zoo").string());
}

TEST_F(FileBrowserTest, WhoIsAskedForAFolderMeansTheOneShownOrThatOfAFile) {
  browser_.open(Purpose::LookForFaces, folder_.path());
  ASSERT_TRUE(browser_.choose(".", chosen_));
  EXPECT_EQ(chosen_, folder_.path());
  EXPECT_FALSE(browser_.choose("zoo", chosen_)) << "it is entered";
  ASSERT_TRUE(browser_.choose(folder_.path() / "a.txt", chosen_));
  EXPECT_EQ(chosen_, folder_.path());
}

TEST_F(FileBrowserTest, ReplacingIsAskedAbout) {
  browser_.open(Purpose::SaveStream, folder_.path(), "new.txt");
  EXPECT_TRUE(browser_.choose("new.txt", chosen_));
  EXPECT_FALSE(browser_.choose("a.txt", chosen_));
  EXPECT_EQ(browser_.view().replaces, (folder_.path() / "a.txt").string());
  EXPECT_FALSE(browser_.choose("b.txt", chosen_)) << "another file is another question";
  EXPECT_TRUE(browser_.choose("b.txt", chosen_));
  EXPECT_EQ(chosen_, folder_.path() / "b.txt");
}

}  // namespace
}  // namespace aucast::gui
