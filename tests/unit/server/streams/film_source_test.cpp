#include "server/streams/film_source.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

TEST(ConditioningFor, TheNeutralFaceOfAFilmOrACameraIsNotTakenOffTwice) {
  sources::ConditioningSettings settings;
  settings.neutral_seconds = 2;
  settings.neutral_turns_only = true;
  for (const char* const seen : {"lecture.mp4", "camera", "camera:/dev/video2"}) {
    EXPECT_FALSE(conditioning_for(seen, settings).neutral_seconds) << seen;
    EXPECT_FALSE(conditioning_for(seen, settings).neutral_turns_only) << seen;
  }
  for (const char* const told : {"lecture.csv", "-"}) {
    EXPECT_EQ(conditioning_for(told, settings).neutral_seconds, 2) << told;
    EXPECT_TRUE(conditioning_for(told, settings).neutral_turns_only) << told;
  }
}

}  // namespace
}  // namespace aucast::server
