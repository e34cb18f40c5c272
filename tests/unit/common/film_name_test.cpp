#include "common/film_name.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(FilmName, IsToldByItsEnding) {
  EXPECT_TRUE(is_film("lecture.mp4"));
  EXPECT_TRUE(is_film("/films/A lecture.MOV"));
  EXPECT_FALSE(is_film("lecture.txt"));
  EXPECT_FALSE(is_film("lecture.csv"));
  EXPECT_FALSE(is_film("mp4"));
}

}  // namespace
}  // namespace aucast
