#include "client/playback/caption_line.h"

#include <gtest/gtest.h>

#include "client/playback/source_playback.h"
#include "tests/unit/playback/scripted_source.h"

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

TEST(CaptionLine, TakesNoMoreThanMayWaitAndGoesOnWhenSomeArePassed) {
  auto owned = std::make_unique<test::ScriptedSource>();
  test::ScriptedSource& source = *owned;
  SourcePlayback playback(std::move(owned), {});
  for (std::size_t i = 0; i < CaptionLine::kWaitingMax + 5; ++i) {
    source.captions.push_back({Milliseconds(i), std::to_string(i)});
  }
  CaptionLine line;
  line.take_from(playback);
  EXPECT_TRUE(line.full());
  EXPECT_EQ(source.captions.size(), 5U) << "the rest waits in the source, whose bound it has";
  line.move_to(2ms);
  line.take_from(playback);
  EXPECT_EQ(source.captions.size(), 2U);
  line.move_to(1h);
  line.take_from(playback);
  line.move_to(1h);
  EXPECT_EQ(line.text(), std::to_string(CaptionLine::kWaitingMax + 4));
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
