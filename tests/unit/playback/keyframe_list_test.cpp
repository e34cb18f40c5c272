#include "client/playback/keyframe_list.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/seeded.h"

namespace aucast::playback {
namespace {

TEST(KeyframeList, GivesEveryKeyframeAsItWas) {
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<Keyframe> keyframes(200);
  for (Keyframe& keyframe : keyframes) {
    for (int i = seeded.integer(0, 8); i > 0; --i) {
      // Of 30 and 46 too, which a text without a side sets on the right alone.
      const auto number = static_cast<std::size_t>(seeded.integer(1, kAuNumberMax));
      const float intensity = static_cast<float>(seeded.integer(1, 1 << 20)) / (1 << 20);
      if (seeded.chance(0.7)) keyframe.aus.left[number] = intensity;
      if (seeded.chance(0.7)) keyframe.aus.right[number] = intensity;
    }
    if (seeded.chance(0.5)) keyframe.time = Milliseconds(seeded.integer(0, 1000));
  }
  const KeyframeList list = keyframes;
  ASSERT_EQ(list.size(), keyframes.size());
  std::size_t index = 0;
  for (const Keyframe& keyframe : list) {
    EXPECT_EQ(keyframe.aus, keyframes[index].aus) << index;
    EXPECT_EQ(keyframe.time, keyframes[index].time) << index;
    EXPECT_EQ(list.aus(index), keyframes[index].aus);
    EXPECT_EQ(list.time(index), keyframes[index].time);
    ++index;
  }
  EXPECT_EQ(index, keyframes.size());
}

TEST(KeyframeList, MayBeEmpty) {
  const KeyframeList list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.begin(), list.end());
}

}  // namespace
}  // namespace aucast::playback
