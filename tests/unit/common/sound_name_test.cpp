#include "common/sound_name.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(SoundName, IsToldByItsEnding) {
  EXPECT_TRUE(is_sound("talk.wav"));
  EXPECT_TRUE(is_sound("/voices/A talk.OPUS"));
  EXPECT_FALSE(is_sound("talk.txt"));
  EXPECT_FALSE(is_sound("wav"));
}

}  // namespace
}  // namespace aucast
