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
}

}  // namespace
}  // namespace aucast
