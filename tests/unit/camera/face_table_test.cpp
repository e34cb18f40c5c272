#include "common/camera/face_table.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/support/read_recording.h"

namespace aucast::camera {
namespace {

mesh::AuWeights some_weights() {
  auto weights = mesh::parse_au_weights(
      "feature lip-gap\nau 12 sided 0 0 1\nau 26 whole 0 0 1\nau 51 turning 0 0 1\n", "w");
  return std::move(*weights);
}

TEST(FaceTable, IsReadBackWithSidesTurnsAndLostFaces) {
  const FaceTable table(some_weights());
  EXPECT_EQ(table.header(), "aucast_seconds,confidence,success,L12,R12,26,51,52\n");
  AuFrame face;
  face.left[12] = 0.25F;
  face.right[12] = 0.75F;
  face.left[26] = face.right[26] = 0.5F;
  face.left[52] = face.right[52] = 1.5F;
  std::string text = table.header();
  text += table.row(0, 0.99, face);
  text += table.row(0.04, 0.99, face);
  text += table.row(0.08, 0, std::nullopt);
  EXPECT_NE(text.find("0.0800,0.000,0,,,,,\n"), std::string::npos);
  const auto recording = sources::read_recording(text, "film.mp4", {});
  ASSERT_TRUE(recording.has_value()) << recording.error().message;
  EXPECT_EQ(recording->found.format, "camera");
  EXPECT_EQ(recording->found.lost, 1U);
  ASSERT_GE(recording->stream.keyframes.size(), 2U);
  const std::vector<AuTerm> expected{
      {12, Side::Left, 25}, {12, Side::Right, 75}, {26, Side::Both, 50}, {52, Side::Both, 100}};
  EXPECT_EQ(recording->stream.keyframes[0].terms, expected);
}

TEST(FaceTable, OfSeveralFacesIsReadFaceByFace) {
  const FaceTable table(some_weights(), true);
  EXPECT_EQ(table.header(), "aucast_seconds,confidence,success,face_id,L12,R12,26,51,52\n");
  AuFrame face;
  std::string text = table.header();
  for (int picture = 0; picture < 3; ++picture) {
    for (const std::size_t number : {0U, 1U}) {
      face.left[26] = face.right[26] = number == 0 ? 0.25F : 0.75F;
      if (picture > 0 || number == 1) text += table.row(0.04 * picture, 0.9, face, number);
    }
  }
  sources::RecordingOptions options;
  for (const auto& [asked, percent] : {std::pair(0, 25), std::pair(1, 75)}) {
    options.face = asked;
    const auto recording = sources::read_recording(text, "film.mp4", options);
    ASSERT_TRUE(recording.has_value()) << recording.error().message;
    EXPECT_EQ(recording->stream.keyframes.back().terms.front().percent, percent);
  }
  const auto most = sources::read_recording(text, "film.mp4", {});
  ASSERT_TRUE(most.has_value());
  EXPECT_EQ(most->stream.keyframes.back().terms.front().percent, 75) << "the more frequent one";
}

TEST(FaceTable, HasATermForEachColumnAlsoOfAbsentAus) {
  const FaceTable table(some_weights());
  AuFrame face;
  face.left[12] = 0.25F;
  face.left[52] = face.right[52] = 1.5F;
  const std::vector<AuTerm> expected{{12, Side::Left, 25},
                                     {12, Side::Right, 0},
                                     {26, Side::Both, 0},
                                     {51, Side::Both, 0},
                                     {52, Side::Both, 100}};
  EXPECT_EQ(table.terms(face), expected);
}

}  // namespace
}  // namespace aucast::camera
