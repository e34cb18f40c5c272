#include "client/app/missing_aus.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

AuFrame set(std::initializer_list<AuTerm> terms) {
  return frame_from_terms({terms.begin(), terms.size()});
}

/// A face that shows AU 12 alone.
face::Face smiling() {
  face::Face face;
  face.name = "smiler";
  face.recordings[12].number = 12;
  return face;
}

TEST(MissingAus, AreSaidOnceEach) {
  const face::Face face = smiling();
  const pipeline::AuMapping mapping{face, face.recordings, {}};
  MissingAus missing;
  EXPECT_EQ(missing.look_at(mapping, set({{12}, {0}})), "");
  EXPECT_EQ(missing.look_at(mapping, set({{12}, {40, Side::Left}})),
            "the face 'smiler' cannot show AU 40 Sniff");
  EXPECT_EQ(missing.look_at(mapping, set({{40}})), "");
  EXPECT_EQ(missing.look_at(mapping, set({{40}, {84}})),
            "the face 'smiler' cannot show AU 84 Head Shake Back and Forth");
  EXPECT_EQ(missing.look_at(mapping, set({{40}, {84}})), "");
}

TEST(MissingAus, WhatTheUserTaughtTheFaceIsNotMissing) {
  const face::Face face = smiling();
  pipeline::AuMapping mapping{face, face.recordings, {}};
  mapping.recordings[40].number = 40;
  EXPECT_EQ(MissingAus().look_at(mapping, set({{40}})), "");
}

}  // namespace
}  // namespace aucast::app
