#include "client/app/window/making/face_session.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::app {
namespace {

namespace fs = std::filesystem;

/// The small face stands in for all faces: it came with the player as "default" and "other", and is
/// the user's own as "mine".
class FaceSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(::setenv("XDG_DATA_HOME", home_.path().c_str(), 1), 0);
    face::test::write_small_face(made_);
    for (const fs::path& face : {shipped("default"), shipped("other"), mine_}) put(face);
    assets_.data_folder = data_.path();
    assets_.face_folder = shipped("default");
    auto face = face::load_face(assets_.face_folder, assets_.data_folder);
    ASSERT_TRUE(face.has_value()) << face.error().message;
    assets_.face = std::move(*face);
    faces_.emplace(assets_);
  }
  void TearDown() override { ASSERT_EQ(::unsetenv("XDG_DATA_HOME"), 0); }

  [[nodiscard]] fs::path shipped(const char* name) const { return data_.path() / "faces" / name; }
  void put(const fs::path& folder) const {
    fs::create_directories(folder.parent_path());
    fs::copy(made_.path(), folder, fs::copy_options::recursive);
  }
  /// "S default, S other, O mine": the kinds and names of the list.
  [[nodiscard]] std::string listed() const {
    std::string text;
    for (const gui::FaceEntry& entry : *faces_->view().entries) {
      text += text.empty() ? "" : ", ";
      text += entry.kind == gui::FaceKind::Shipped ? "S "
              : entry.kind == gui::FaceKind::Own   ? "O "
                                                   : "E ";
      text += entry.name;
    }
    return text;
  }

  test::TempFolder home_;
  test::TempFolder data_;
  test::TempFolder made_;
  test::TempFolder elsewhere_;
  fs::path mine_ = home_.path() / "aucast" / "faces" / "mine";
  Assets assets_;
  std::optional<FaceSession> faces_;
};

TEST_F(FaceSessionTest, ListsWhatCameWithThePlayerAndOnesOwn) {
  EXPECT_EQ(listed(), "S default, S other, O mine");
  EXPECT_EQ(faces_->view().shown, shipped("default").string());
  EXPECT_EQ(faces_->view().elsewhere, "");
  EXPECT_EQ(faces_->changes(), 0U);
  EXPECT_EQ(faces_->next(), "");
}

TEST_F(FaceSessionTest, ShowsAnotherFaceAndTellsTheChannelsOfTheLast) {
  const std::size_t channels = assets_.face.channels.size();
  const auto before = faces_->show(mine_);
  ASSERT_TRUE(before.has_value()) << before.error().message;
  EXPECT_EQ(before->size(), channels);
  EXPECT_EQ(assets_.face_folder, mine_);
  EXPECT_EQ(faces_->view().shown, mine_.string());
  EXPECT_EQ(faces_->changes(), 1U);
}

TEST_F(FaceSessionTest, RemembersAShippedFaceByItsNameAndAnotherByItsFolder) {
  ASSERT_TRUE(faces_->show(mine_).has_value());
  EXPECT_EQ(faces_->next(), mine_.string());
  ASSERT_TRUE(faces_->show(shipped("other") / "").has_value());
  EXPECT_EQ(faces_->next(), "other") << "shipped faces may lie elsewhere next time";
  faces_->remember("");
  EXPECT_EQ(faces_->next(), "");
}

TEST_F(FaceSessionTest, AFaceThatCannotBeReadChangesNothing) {
  std::ofstream(mine_ / "face.toml") << "no face\n";
  EXPECT_FALSE(faces_->show(mine_).has_value());
  EXPECT_FALSE(faces_->show("/no/such/face").has_value());
  EXPECT_EQ(assets_.face_folder, shipped("default"));
  EXPECT_EQ(faces_->changes(), 0U);
  EXPECT_EQ(faces_->next(), "");
}

TEST_F(FaceSessionTest, ListsTheFacesBesideOneFromElsewhere) {
  for (const char* name : {"anna", "bert"}) put(elsewhere_.path() / name);
  ASSERT_TRUE(faces_->show(elsewhere_.path() / "anna").has_value());
  EXPECT_EQ(listed(), "S default, S other, O mine, E anna, E bert");
  EXPECT_EQ(faces_->view().elsewhere, elsewhere_.path().string());
  ASSERT_TRUE(faces_->show(shipped("default")).has_value());
  EXPECT_EQ(listed(), "S default, S other, O mine, E anna, E bert") << "they stay";
}

TEST_F(FaceSessionTest, LooksInAFolderWithoutShowingAFace) {
  put(elsewhere_.path() / "anna");
  faces_->look_in(elsewhere_.path());
  EXPECT_EQ(listed(), "S default, S other, O mine, E anna");
  EXPECT_EQ(faces_->view().shown, shipped("default").string());
  faces_->look_in(data_.path() / "faces");
  EXPECT_EQ(listed(), "S default, S other, O mine") << "these are listed already";
}

TEST_F(FaceSessionTest, AnUnchangedCopyOfAShippedFaceIsThatFace) {
  for (const char* name : {"default", "other"}) put(elsewhere_.path() / name);
  ASSERT_TRUE(faces_->show(elsewhere_.path() / "other").has_value());
  EXPECT_EQ(listed(), "S default, S other, O mine");
  EXPECT_EQ(faces_->view().shown, shipped("other").string());
  std::ofstream(elsewhere_.path() / "other" / "face.toml", std::ios::app) << "# changed\n";
  ASSERT_TRUE(faces_->show(elsewhere_.path() / "other").has_value());
  EXPECT_EQ(listed(), "S default, S other, O mine, E other");
}

TEST_F(FaceSessionTest, ShippedFacesInThePlaceOfOnesOwnAreNotAddedTo) {
  fs::remove_all(mine_.parent_path());
  fs::create_directory_symlink(data_.path() / "faces", mine_.parent_path());
  const auto copy = faces_->copy(shipped("default"), "anna");
  ASSERT_FALSE(copy.has_value());
  EXPECT_NE(copy.error().message.find("leads to the shipped faces"), std::string::npos)
      << copy.error().message;
  EXPECT_FALSE(fs::exists(shipped("anna")));
}

}  // namespace
}  // namespace aucast::app
