#include "client/gui/storage/user_face.h"

#include <gtest/gtest.h>

#include "tests/unit/gui/storage/user_face_fixture.h"

namespace aucast::gui {
namespace {

namespace fs = std::filesystem;

using UserFace = UserFaceTest;

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
  EXPECT_TRUE(faces[1].target.empty());
  EXPECT_TRUE(faces_in("/no/such/folder").empty());
}

TEST_F(UserFace, AFaceThatIsBeingMadeIsNotListed) {
  fs::create_directories(mine_);
  fs::copy(shipped_, mine_ / ".plain.unfinished", fs::copy_options::recursive);
  EXPECT_TRUE(faces_in(mine_).empty());
}

TEST_F(UserFace, OfALinkItIsSaidWhereItLeads) {
  fs::create_directories(mine_);
  fs::create_directory_symlink(shipped_, mine_ / "linked");
  ASSERT_EQ(faces_in(mine_).size(), 1U);
  EXPECT_EQ(faces_in(mine_)[0].target, shipped_.string());
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

TEST_F(UserFace, OfAFaceThatAnotherProgramTookAwayItIsSaidThatItIsGone) {
  fs::remove_all(shipped_);
  const auto file = save_aus(shipped_, {{77, {}, {}}});
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().message, shipped_.string() + ": this face is gone; choose another one");
}

TEST_F(UserFace, AClassicFaceHasNoAusOfItsOwn) {
  fs::remove(shipped_ / "face.toml");
  folder_.write("shipped/plain/faceline.dat", "0\n");
  const auto file = save_aus(shipped_, {{77, {}, {}}});
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("is a classic face"), std::string::npos);
}

}  // namespace
}  // namespace aucast::gui
