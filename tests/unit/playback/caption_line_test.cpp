#include "client/playback/caption_line.h"

#include <gtest/gtest.h>

namespace aucast::playback {
namespace {

using namespace std::chrono_literals;

TEST(CaptionLine, SaysWhatBelongsToThePlace) {
  CaptionLine line;
  line.add({1000ms, "one"});
  line.add({2000ms, ""});
  line.add({3000ms, "three"});
  line.move_to(999ms);
  EXPECT_EQ(line.text(), "");
  line.move_to(1000ms);
  EXPECT_EQ(line.text(), "one");
  line.move_to(1999ms);
  EXPECT_EQ(line.text(), "one");
  line.move_to(2500ms);
  EXPECT_EQ(line.text(), "");
  line.move_to(3500ms);
  EXPECT_EQ(line.text(), "three");
}

TEST(CaptionLine, WhatIsPassedAtOnceIsNotSaid) {
  CaptionLine line;
  for (const char* text : {"one", "two", "three"}) line.add({1000ms, text});
  line.move_to(1000ms);
  EXPECT_EQ(line.text(), "three");
}

TEST(CaptionLine, StaysWhenPlacesGoBack) {
  CaptionLine line;
  line.add({1000ms, "one"});
  line.add({2000ms, "two"});
  line.move_to(1500ms);
  line.move_to(500ms);
  EXPECT_EQ(line.text(), "one");
}

}  // namespace
}  // namespace aucast::playback
