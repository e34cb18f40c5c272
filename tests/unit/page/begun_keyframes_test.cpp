#include "client/web/begun_keyframes.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/codec.h"

namespace aucast::web {
namespace {

using Lines = std::vector<std::string>;

BegunKeyframes::Begun keyframe(int second) {
  return {Instant(std::chrono::seconds(second)), *protocol::parse_au_set("12"),
          std::to_string(second)};
}

TEST(BegunKeyframes, AreTakenOnceTheyAreHeard) {
  BegunKeyframes begun;
  for (const int second : {1, 2, 3}) begun.add(keyframe(second));
  EXPECT_EQ(begun.pass(Instant{}), std::nullopt);
  EXPECT_EQ(begun.take_lines(), Lines());
  EXPECT_TRUE(begun.pass(Instant(std::chrono::seconds(2))).has_value());
  EXPECT_EQ(begun.take_lines(), (Lines{"1", "2"}));
  EXPECT_EQ(begun.take_lines(), Lines());
  begun.clear();
  EXPECT_EQ(begun.pass(Instant(std::chrono::seconds(9))), std::nullopt);
}

TEST(BegunKeyframes, OfTooManyTheOldestLineGoes) {
  BegunKeyframes begun;
  constexpr int kMax = static_cast<int>(BegunKeyframes::kMax);
  for (int second = 1; second <= kMax + 2; ++second) {
    begun.add(keyframe(second));
    begun.pass(Instant(std::chrono::seconds(second)));
  }
  const Lines lines = begun.take_lines();
  ASSERT_EQ(lines.size(), BegunKeyframes::kMax);
  EXPECT_EQ(lines.front(), "3");
  EXPECT_EQ(lines.back(), std::to_string(kMax + 2));
}

TEST(BegunKeyframes, OfTooManyThatAreNotHeardTheOldestGoes) {
  BegunKeyframes begun;
  constexpr int kMax = static_cast<int>(BegunKeyframes::kMax);
  for (int second = 1; second <= kMax + 1; ++second) begun.add(keyframe(second));
  begun.pass(Instant(std::chrono::seconds(kMax + 1)));
  EXPECT_EQ(begun.take_lines().front(), "2");
}

}  // namespace
}  // namespace aucast::web
