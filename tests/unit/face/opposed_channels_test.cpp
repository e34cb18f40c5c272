#include "client/face/opposed_channels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

TEST(OpposedChannels, SayHowFarOneIsAheadOfTheOther) {
  const std::vector<float> activations{0.75F, 0.25F};
  EXPECT_EQ((OpposedChannels{0, 1}.of(activations)), 0.5F);
  EXPECT_EQ((OpposedChannels{1, 0}.of(activations)), -0.5F);
  EXPECT_EQ((OpposedChannels{0, std::nullopt}.of(activations)), 0.75F);
  EXPECT_EQ((OpposedChannels{std::nullopt, 0}.of(activations)), -0.75F);
  EXPECT_EQ((OpposedChannels{}.of(activations)), 0.0F);
}

TEST(OpposedChannels, AreFoundByNameAndSide) {
  const Face face = test::small_face();
  const OpposedChannels nod = opposed(face, kHeadPitch);
  EXPECT_EQ(nod.plus, face.channel_index("head_up"));
  EXPECT_EQ(nod.minus, face.channel_index("head_down"));
  const OpposedChannels look = opposed(face, kGazeYaw, Side::Right);
  EXPECT_EQ(look.plus, face.channel_index("right_gaze_left"));
  EXPECT_EQ(look.minus, face.channel_index("right_gaze_right"));
  const OpposedChannels none = opposed(face, kGazeYaw);
  EXPECT_FALSE(none.plus || none.minus) << "an eye has a side";
}

TEST(OpposedChannels, AreAllThatAFaceWithEyesAndHeadHasOfThem) {
  const Face face = test::small_face();
  std::vector<std::string> names;
  for (const OpposedNames& pair : kOpposedNames) {
    for (const std::string_view name : {pair.plus, pair.minus}) {
      for (const Side side : {Side::Both, Side::Left, Side::Right}) {
        const std::string sided = sided_name(side, name);
        if (face.channel_index(sided)) names.push_back(sided);
      }
    }
  }
  const auto turns_something = [](const Channel& channel) {
    return channel.name.find("gaze_") != std::string::npos || channel.name.starts_with("head_");
  };
  EXPECT_EQ(static_cast<std::ptrdiff_t>(names.size()),
            std::count_if(face.channels.begin(), face.channels.end(), turns_something));
}

}  // namespace
}  // namespace aucast::face
