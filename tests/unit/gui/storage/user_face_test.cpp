#include "client/gui/storage/user_face.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::gui {
namespace {

namespace fs = std::filesystem;

/// A shipped face "plain" and a place for the user's own.
class UserFace : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(shipped_);
    test::TempFolder made;
    face::test::write_small_face(made);
    fs::copy(made.path(), shipped_, fs::copy_options::recursive);
  }

  test::TempFolder folder_;
  fs::path shipped_ = folder_.path() / "shipped" / "plain";
  fs::path mine_ = folder_.path() / "home" / "aucast" / "faces";
};

TEST_F(UserFace, TheFolderIsWhereTheDesktopSpecificationWantsIt) {
  EXPECT_EQ(*user_faces_folder("/data", "/home/a"), "/data/aucast/faces");
  EXPECT_EQ(*user_faces_folder(nullptr, "/home/a"), "/home/a/.local/share/aucast/faces");
  EXPECT_EQ(*user_faces_folder("", "/home/a"), "/home/a/.local/share/aucast/faces");
  EXPECT_EQ(*user_faces_folder("relative", "/home/a"), "/home/a/.local/share/aucast/faces");
  const auto nowhere = user_faces_folder(nullptr, nullptr);
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().message,
            "no place for your own faces: set HOME or XDG_DATA_HOME to a folder");
}

TEST_F(UserFace, FacesOfAFolderAreListedByName) {
  fs::create_directories(folder_.path() / "shipped" / "nothing");
  fs::copy(shipped_, folder_.path() / "shipped" / "another", fs::copy_options::recursive);
  const auto faces = faces_in(folder_.path() / "shipped");
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].name, "another");
  EXPECT_EQ(faces[1].folder, shipped_.string());
  EXPECT_TRUE(faces_in("/no/such/folder").empty());
}

TEST_F(UserFace, AShippedFaceIsCopiedOnce) {
  const auto copy = writable_face(shipped_, mine_);
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(*copy, mine_ / "plain");
  EXPECT_TRUE(face::load_face(*copy, folder_.path()));
  folder_.write("home/aucast/faces/plain/aus.toml", "mine");
  EXPECT_EQ(*writable_face(shipped_ / "", mine_), *copy);
  EXPECT_EQ(folder_.read("home/aucast/faces/plain/aus.toml"), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(mine_), {}), 1);
}

TEST_F(UserFace, ACopyHasWhatItsFaceTakesFromAnother) {
  const fs::path other = shipped_.parent_path() / "other";
  fs::create_directories(other);
  fs::copy(shipped_ / "mesh.ply", other / "mesh.ply");
  std::string text = folder_.read("shipped/plain/face.toml");
  for (const std::string file : {"muscles.toml", "aus.toml"}) {
    text.replace(text.find('"' + file), 1, "\"../plain/");
  }
  folder_.write("shipped/other/face.toml", text);
  ASSERT_TRUE(face::load_face(other, folder_.path()));
  const auto copy = writable_face(other, mine_);
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(folder_.read("home/aucast/faces/other/face.toml"),
            folder_.read("shipped/plain/face.toml"));
  const auto file = save_aus(*copy, {{77, {{"jaw", 1.5F}}, {}}});
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(*file, *copy / "aus.toml");
  const auto face = face::load_face(*copy, folder_.path());
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_TRUE(face->recordings.contains(77));
  EXPECT_FALSE(face::load_face(other, folder_.path())->recordings.contains(77));
}

TEST_F(UserFace, TheUsersOwnFaceIsWrittenWhereItIs) {
  const auto copy = writable_face(shipped_, mine_);
  ASSERT_TRUE(copy);
  EXPECT_EQ(*writable_face(*copy, mine_), *copy);
}

TEST_F(UserFace, SavingKeepsThePreviousVersionAndNothingElse) {
  const std::string before = folder_.read("shipped/plain/aus.toml");
  const auto file = save_aus(shipped_, {{77, {{"jaw", 1.5F}}, {}}});
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(*file, shipped_ / "aus.toml");
  EXPECT_EQ(folder_.read("shipped/plain/aus.toml~"), before);
  EXPECT_EQ(folder_.read("shipped/plain/aus.toml"),
            before + "\n[[au]]\nnumber = 77\ndrive = { jaw = 1.5 }\n");
  const auto face = face::load_face(shipped_, folder_.path());
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_EQ(face->recordings.at(77).activation[*face->channel_index("jaw")], 1.5F);
  const auto files = std::distance(fs::directory_iterator(shipped_), {});
  EXPECT_EQ(files, 5);
}

TEST_F(UserFace, AnAuIsNamedAndRemoved) {
  const std::string before = folder_.read("shipped/plain/aus.toml");
  ASSERT_TRUE(save_aus(shipped_, {{77, {{"jaw", 1.5F}}, "yawn"}}));
  const auto face = face::load_face(shipped_, folder_.path());
  ASSERT_TRUE(face) << face.error().message;
  EXPECT_EQ(face->recordings.at(77).note, "yawn");
  ASSERT_TRUE(remove_au(shipped_, 77));
  EXPECT_EQ(folder_.read("shipped/plain/aus.toml"), before);
  EXPECT_NE(folder_.read("shipped/plain/aus.toml~").find("yawn"), std::string::npos);
}

TEST_F(UserFace, SavingTheSameAgainKeepsTheOlderVersion) {
  const std::string before = folder_.read("shipped/plain/aus.toml");
  ASSERT_TRUE(save_aus(shipped_, {{77, {{"jaw", 1.5F}}, {}}}));
  ASSERT_TRUE(save_aus(shipped_, {{77, {{"jaw", 1.5F}}, {}}}));
  EXPECT_EQ(folder_.read("shipped/plain/aus.toml~"), before);
}

/// A folder in the file's place cannot be written, whoever runs the test.
TEST_F(UserFace, AFailedSavingLeavesTheFileAsItWas) {
  const std::string before = folder_.read("shipped/plain/aus.toml");
  fs::create_directory(shipped_ / "aus.toml~");
  const auto file = save_aus(shipped_, {{77, {{"jaw", 1.5F}}, {}}});
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, ErrorKind::Failed);
  EXPECT_NE(file.error().message.find("aus.toml~"), std::string::npos) << file.error().message;
  EXPECT_EQ(folder_.read("shipped/plain/aus.toml"), before);
}

TEST_F(UserFace, ACopyThatCannotBeMadeIsSaid) {
  folder_.write("home", "a file where a folder should be");
  const auto copy = writable_face(shipped_, mine_);
  ASSERT_FALSE(copy);
  EXPECT_EQ(copy.error().message.find("this face cannot be copied to " + mine_.string() + ": "), 0U)
      << copy.error().message;
}

TEST_F(UserFace, AClassicFaceHasNoAusOfItsOwn) {
  fs::remove(shipped_ / "face.toml");
  const auto file = save_aus(shipped_, {{77, {}, {}}});
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("is a classic face"), std::string::npos);
}

}  // namespace
}  // namespace aucast::gui
