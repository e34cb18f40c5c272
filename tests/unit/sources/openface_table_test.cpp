#include "common/sources/openface_table.h"

#include <array>

#include <gtest/gtest.h>

#include "common/sources/recording.h"
#include "protocol/codec.h"
#include "tests/support/read_recording.h"
#include "tests/support/seeded.h"

namespace aucast::sources {
namespace {

protocol::Keyframe keyframe(std::vector<AuTerm> terms, std::optional<std::uint32_t> time_ms) {
  return {std::move(terms), false, time_ms, std::nullopt};
}

protocol::StreamFile read_again(const OpenFaceTable& table) {
  auto recording = read_recording(table.text, "written.csv", {});
  if (!recording) {
    ADD_FAILURE() << recording.error().message;
    return {};
  }
  return std::move(recording->stream);
}

TEST(OpenFaceTable, HasOpenFacesColumnsAndWhatElseOccurs) {
  const auto table = write_openface_table(
      {{keyframe({{12, Side::Both, 50}, {18, Side::Both, 100}, {57, Side::Both, 50}}, 40)}}, 250);
  EXPECT_EQ(
      table.text,
      "frame,face_id,timestamp,confidence,success,gaze_angle_x,gaze_angle_y,"
      "pose_Tz,pose_Rx,pose_Ry,pose_Rz,AU01_r,AU02_r,AU04_r,AU05_r,AU06_r,AU07_r,AU09_r,AU10_r,"
      "AU12_r,AU14_r,AU15_r,AU17_r,AU18_r,AU20_r,AU23_r,AU25_r,AU26_r,AU45_r\n"
      "1,0,0.040,1.00,1,0.000000,0.000000,593.0,0.000000,0.000000,0.000000,0.00,0.00,0.00,0.00,"
      "0.00,0.00,0.00,0.00,2.50,0.00,0.00,0.00,5.00,0.00,0.00,0.00,0.00,0.00\n");
}

TEST(OpenFaceTable, ReadAgainIsTheSameStream) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  constexpr std::array<std::uint8_t, 7> kPlain{1, 2, 12, 28, 33, 43, 99};
  constexpr std::array<std::uint8_t, 5> kTurns{51, 53, 55, 61, 63};
  for (int round = 0; round < 50; ++round) {
    protocol::StreamFile stream;
    for (int index = 0; index < 20; ++index) {
      std::vector<AuTerm> terms;
      const auto percent = [&] { return static_cast<std::uint8_t>(seeded.integer(1, 100)); };
      for (const std::uint8_t number : kPlain) terms.push_back({number, Side::Both, percent()});
      for (const std::uint8_t number : kTurns) {
        const auto towards = static_cast<std::uint8_t>(number + seeded.integer(0, 1));
        terms.push_back({towards, Side::Both, percent()});
      }
      stream.keyframes.push_back(keyframe(canonical_terms(frame_from_terms(terms)), 33));
    }
    EXPECT_EQ(protocol::format_stream_file(read_again(write_openface_table(stream, 250))),
              protocol::format_stream_file(stream));
  }
}

TEST(OpenFaceTable, LongKeyframesAreWrittenInStraightLines) {
  const auto table = write_openface_table(
      {{keyframe({{12, Side::Both, 100}}, 200), keyframe({{0, Side::Both, 100}}, std::nullopt)}},
      150);
  EXPECT_EQ(table.rows, 4U);
  const auto again = read_again(table);
  ASSERT_EQ(again.keyframes.size(), 4U);
  // The first row of a table takes the time between its last two.
  EXPECT_EQ(protocol::encode(again.keyframes[0]), "{12:50;75}");
  EXPECT_EQ(protocol::encode(again.keyframes[1]), "{12;100}");
  EXPECT_EQ(protocol::encode(again.keyframes[2]), "{12:50;75}");
  EXPECT_EQ(protocol::encode(again.keyframes[3]), "{0;75}");
}

TEST(OpenFaceTable, OfSidesTheStrongerOneAndOfAMomentTheLastFace) {
  const auto table =
      write_openface_table({{keyframe({{6, Side::Both, 10}}, 40),
                             keyframe({{12, Side::Left, 40}, {12, Side::Right, 80}}, 0)}},
                           250);
  EXPECT_EQ(table.uneven, 1U);
  EXPECT_EQ(table.rows, 1U);
  const auto again = read_again(table);
  ASSERT_EQ(again.keyframes.size(), 1U);
  EXPECT_EQ(again.keyframes[0].terms, (std::vector<AuTerm>{{12, Side::Both, 80}}));
}

}  // namespace
}  // namespace aucast::sources
