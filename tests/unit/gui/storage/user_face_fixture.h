#pragma once

#include <filesystem>

#include <gtest/gtest.h>

#include "client/gui/storage/face_copies.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::gui {

/// A shipped face "plain" and a folder for the user's own faces.
class UserFaceTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(shipped_);
    test::TempFolder made;
    face::test::write_small_face(made);
    std::filesystem::copy(made.path(), shipped_, std::filesystem::copy_options::recursive);
  }

  test::TempFolder folder_;
  std::filesystem::path shipped_ = folder_.path() / "shipped" / "plain";
  std::filesystem::path mine_ = folder_.path() / "home" / "aucast" / "faces";
  FaceFolders faces_{shipped_.parent_path(), mine_};
};

}  // namespace aucast::gui
