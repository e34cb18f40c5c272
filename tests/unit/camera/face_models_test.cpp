#include "common/camera/face_models.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "common/files.h"
#include "tests/support/temp_folder.h"

namespace aucast::camera {
namespace {

TEST(FaceModels, SayWhatToDoWhenTheyAreNotThere) {
  const test::TempFolder folder;
  const auto models = load_face_models(folder.path());
  ASSERT_FALSE(models.has_value());
  EXPECT_EQ(models.error().kind, ErrorKind::Unreadable);
  const std::string where = folder.path().string();
  EXPECT_NE(models.error().message.find("'scripts/install_models.sh " + where), std::string::npos);
  // Where it is installed, nobody has a checkout.
  folder.write("scripts/install_models.sh", "");
  EXPECT_NE(load_face_models(folder.path())
                .error()
                .message.find("'" + where + "/scripts/install_models.sh " + where),
            std::string::npos);
}

TEST(FaceModels, ThatAreNoneAreBadData) {
  const test::TempFolder folder;
  std::filesystem::create_directory(folder.path() / "models");
  std::filesystem::create_directory(folder.path() / "camera");
  for (const char* name :
       {"face_detection_short_range.tflite", "face_landmark_with_attention.tflite"}) {
    ASSERT_TRUE(write_file_atomically(folder.path() / "models" / name, "not a model at all"));
  }
  ASSERT_TRUE(write_file_atomically(folder.path() / "camera" / "action_units.txt",
                                    "feature lip-gap\nau 12 sided 0 0 1\n"));
  const auto models = load_face_models(folder.path());
  ASSERT_FALSE(models.has_value());
  EXPECT_EQ(models.error().kind, ErrorKind::BadData);
  EXPECT_TRUE(models.error().message.ends_with("it is no TFLite file; 'scripts/install_models.sh " +
                                               folder.path().string() + "' fetches it anew"))
      << models.error().message;
}

}  // namespace
}  // namespace aucast::camera
