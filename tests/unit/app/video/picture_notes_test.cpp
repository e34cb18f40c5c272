#include "client/app/video/picture_notes.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

std::string text_of(const std::vector<view::PngText>& texts, const std::string& keyword) {
  for (const view::PngText& one : texts) {
    if (one.keyword == keyword) return one.text;
  }
  return {};
}

TEST(PictureNotes, SayWhatTheFaceIsMadeOf) {
  const face::Face face;
  PictureNotes notes{face, std::nullopt};
  notes.rules = "facs";
  EXPECT_EQ(text_of(texts_of(notes), "Rules"), "") << "muscles know no rules";
  notes.edited = "12_edited";
  EXPECT_EQ(text_of(texts_of(notes), "Edited"), "12_edited");
  EXPECT_EQ(text_of(texts_of(notes), "Rules"), "facs");
  notes.edited = {};
  notes.aus = AuFrame();
  notes.aus->left[12] = notes.aus->right[12] = 1;
  EXPECT_EQ(text_of(texts_of(notes), "AUs"), "12");
  EXPECT_EQ(text_of(texts_of(notes), "Edited"), "");
}

}  // namespace
}  // namespace aucast::app
