#include "client/gui/model/picture_settings.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

const PictureWords kWords{"marek", "talk", "12", "au06_au12-80", "2026-11-23"};

TEST(PictureSettings, WordsInBracesAreWhatIsShown) {
  EXPECT_EQ(*picture_name("face-player-{number}", kWords, 3), "face-player-3");
  EXPECT_EQ(*picture_name("{face}_{stream}_{keyframe}", kWords, 1), "marek_talk_12");
  EXPECT_EQ(*picture_name("{date} {aus}", kWords, 1), "2026-11-23 au06_au12-80");
  EXPECT_EQ(*picture_name("{stream}", {}, 1), "none") << "nothing plays";
}

TEST(PictureSettings, WhatCannotStandInANameDoesNot) {
  PictureWords words;
  words.stream = "../a b:c";
  EXPECT_EQ(*picture_name("x{stream}", words, 1), "x..-a-b-c");
  words.stream.assign(300, 'a');
  EXPECT_LE(picture_name("{stream}", words, 1)->size(), 80U);
  words.stream = "x";
  for (int n = 0; n < 100; ++n) words.stream += "\u0436";
  EXPECT_EQ(picture_name("{stream}", words, 1)->size(), 79U) << "no half of a letter";
}

TEST(PictureSettings, APatternThatMeansNothingIsSaid) {
  const auto problem = [](const char* pattern) {
    const auto name = picture_name(pattern, kWords, 1);
    return name ? "" : name.error().message;
  };
  EXPECT_NE(problem("{nummer}").find("{nummer} stands for nothing"), std::string::npos);
  EXPECT_NE(problem("a{number").find("without its }"), std::string::npos);
  EXPECT_NE(problem("").find("empty"), std::string::npos);
  EXPECT_NE(problem("a/b").find("folder"), std::string::npos);
  EXPECT_NE(problem(".a").find("hidden"), std::string::npos);
}

}  // namespace
}  // namespace aucast::gui
