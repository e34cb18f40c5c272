#include "client/gui/model/expression_search.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

const ExpressionButton kSad{.label = "Sadness",
                            .aus = "1:50,L15:12",
                            .kind = ExpressionKind::Other,
                            .source = "Ekman 2002",
                            .name = "sadness-2"};

TEST(ExpressionSearch, FindsLabelNumbersAndSource) {
  for (const char* words : {"", "sad", "sadness-2", "1:50", "1:50 l15", "ekman"}) {
    EXPECT_TRUE(is_meant(kSad, words)) << words;
  }
  for (const char* words : {"joy", "6,12", "1 15"}) EXPECT_FALSE(is_meant(kSad, words)) << words;
}

TEST(ExpressionSearch, FindsAusByTheirFacsNames) {
  for (const char* words : {"inner brow raiser", "brow ra", "lip corner depressor"}) {
    EXPECT_TRUE(is_meant(kSad, words)) << words;
  }
  EXPECT_FALSE(is_meant(kSad, "lip corner puller")) << "12 is an intensity here";
  EXPECT_FALSE(is_meant(kSad, "lip pressor"));
  const ExpressionButton tense{.label = "x", .aus = "24"};
  EXPECT_TRUE(is_meant(tense, "lip pressor")) << "as the thesis calls it";
  const ExpressionButton muscles{.label = "x", .aus = "0"};
  EXPECT_FALSE(is_meant(muscles, "neutral face")) << "it has no AUs";
}

}  // namespace
}  // namespace aucast::gui
