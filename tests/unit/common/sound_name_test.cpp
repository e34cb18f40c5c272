#include "common/sound_name.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast {
namespace {

TEST(SoundName, IsToldByItsEnding) {
  EXPECT_TRUE(is_sound("talk.wav"));
  EXPECT_TRUE(is_sound("/voices/A talk.OPUS"));
  EXPECT_FALSE(is_sound("talk.txt"));
  EXPECT_FALSE(is_sound("wav"));
}

TEST(SoundBeside, IsTheFileOfTheSameName) {
  const test::TempFolder folder;
  const auto stream = folder.write("talk.txt", "{12 100}\n");
  EXPECT_FALSE(sound_beside(stream).has_value());
  folder.write("talk.mp3", "x");
  EXPECT_EQ(sound_beside(stream), folder.path() / "talk.mp3");
  folder.write("talk.wav", "x");
  EXPECT_EQ(sound_beside(stream), folder.path() / "talk.wav");
  EXPECT_FALSE(file_beside(stream, ".txt")) << "the source itself";
}

TEST(SoundBeside, IsNoFolder) {
  const test::TempFolder folder;
  const auto stream = folder.write("talk.txt", "{12 100}\n");
  std::filesystem::create_directory(folder.path() / "talk.wav");
  EXPECT_EQ(sound_beside(stream), std::nullopt);
  std::filesystem::create_directory_symlink(folder.path() / "talk.wav",
                                            folder.path() / "talk.flac");
  EXPECT_EQ(sound_beside(stream), std::nullopt);
  folder.write("talk.mp3", "x");
  EXPECT_EQ(sound_beside(stream), folder.path() / "talk.mp3");
}

TEST(SoundBeside, IsALinkToNowhereToo) {
  const test::TempFolder folder;
  const auto stream = folder.write("talk.txt", "{12 100}\n");
  folder.write("talk.mp3", "x");
  std::filesystem::create_symlink("gone", folder.path() / "talk.wav");
  EXPECT_EQ(sound_beside(stream), folder.path() / "talk.wav") << "whoever reads it says so";
}

}  // namespace
}  // namespace aucast
