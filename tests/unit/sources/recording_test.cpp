#include "common/sources/recording.h"

#include <stop_token>

#include <gtest/gtest.h>

#include "common/sources/found_report.h"
#include "common/sources/source_reader.h"
#include "protocol/codec.h"
#include "tests/support/read_recording.h"
#include "tests/support/seeded.h"
#include "tests/unit/sources/tables.h"

namespace aucast::sources {
namespace {

using tables::kOpenFace2Header;
using tables::openface2_row;

constexpr const char* kSmile = "0,5,0,0,0,0,0";
constexpr const char* kNoData = ",,,,,,";

std::string row(int frame, const std::string& seconds, const std::string& aus = kSmile) {
  return openface2_row(frame, seconds, aus);
}

Recording read_rows(const std::string& rows, const RecordingOptions& options = {}) {
  auto recording = read_recording(kOpenFace2Header + rows, "f.csv", options);
  if (!recording) {
    ADD_FAILURE() << recording.error().message;
    return {};
  }
  return std::move(*recording);
}

Error error_of(const std::string& text, const RecordingOptions& options = {}) {
  const auto recording = read_recording(text, "f.csv", options);
  if (!recording) return recording.error();
  ADD_FAILURE() << "accepted";
  return {};
}

std::string packet_of(const Recording& recording, std::size_t index) {
  if (index >= recording.stream.keyframes.size()) return "no such keyframe";
  return protocol::encode(recording.stream.keyframes[index]);
}

TEST(Recording, TheSourcesClockIsTheClock) {
  std::string rows;
  for (int frame = 0; frame < 301; ++frame) {
    const int ms = frame * 1000 / 30;
    const std::string fraction = std::to_string(1000 + ms % 1000).substr(1);
    rows += row(frame + 1, std::to_string(ms / 1000) + "." + fraction);
  }
  const auto recording = read_rows(rows);
  EXPECT_EQ(recording.stream.keyframes.size(), 301U);
  EXPECT_EQ(protocol::media_ms(recording.stream, 250), 10'033U) << "10 s and the first keyframe";
}

TEST(Recording, AskedToStopItIsNoShorterRecordingButAnError) {
  std::stop_source stop;
  const std::string table = kOpenFace2Header + row(1, "0.0") + row(2, "0.1");
  for (const std::string& text : {table, std::string("Beg_Stream\n1\n6,12\nEnd_Stream\n")}) {
    EXPECT_TRUE(parse_streams(text, "f", {}, {}));
    stop.request_stop();
    EXPECT_FALSE(parse_streams(text, "f", {}, {}, stop.get_token()));
  }
}

TEST(Recording, ScaleCanBeAsked) {
  RecordingOptions options;
  options.au_scale = 100;
  const auto recording = read_rows(row(1, "0", "50,0,0,0,0,0,0") + row(2, "0.1"), options);
  EXPECT_EQ(packet_of(recording, 0), "{1:50;100}");
  EXPECT_TRUE(recording.found.scale_asked);
  EXPECT_NE(found_sentence(recording.found).find("AU scale 0-100 as asked, largest 50.00"),
            std::string::npos);
}

TEST(Recording, PercentIsFoundAndValuesBeyondTheScaleAreFull) {
  EXPECT_EQ(read_rows(row(1, "0", "60,0,0,0,0,0,0") + row(2, "0.1")).found.scale, 100);
  const auto recording = read_rows(row(1, "0", "5.5,-1,0,0,0,0,0") + row(2, "0.1"));
  EXPECT_EQ(recording.found.scale, 5);
  EXPECT_EQ(packet_of(recording, 0), "{1;100}") << "clamped at both ends";
}

TEST(Recording, AValueThatFitsNoScaleIsNoData) {
  const auto recording =
      read_rows(row(1, "0", "4,0,0,0,0,0,0") + row(2, "0.1", "99999,0,0,0,0,0,0") +
                row(3, "0.2", "4,0,0,0,0,0,0"));
  EXPECT_EQ(recording.found.scale, 5);
  EXPECT_EQ(recording.found.off_scale, 1U);
  for (std::size_t at = 0; at < 3; ++at)
    EXPECT_TRUE(packet_of(recording, at).starts_with("{1:80;"));
  const std::string said = "1 AU value above 100 left out, for no scale has them";
  EXPECT_EQ(warnings(recording.found, {}), std::vector{said});
  EXPECT_NE(found_lines(recording.found).find(said), std::string::npos);
  EXPECT_NE(found_sentence(recording.found).find(said), std::string::npos);
}

TEST(Recording, UnsureRowsHoldThenEase) {
  std::string rows = row(1, "0.0");
  for (int frame = 1; frame <= 20; ++frame) {
    rows += openface2_row(frame + 1, std::to_string(frame / 10.0), "3,3,3,1,1,1,1", "0",
                          frame % 2 == 0 ? "0.98,0" : "0.2,1");
  }
  const auto recording = read_rows(rows);
  EXPECT_EQ(recording.found.lost, 20U);
  EXPECT_EQ(recording.found.gaps, 1U);
  EXPECT_NEAR(recording.found.gap_seconds_max, 2, 1e-9);
  EXPECT_EQ(packet_of(recording, 4), "{12;100}");
  EXPECT_EQ(packet_of(recording, 10), "{12:50;100}");
  EXPECT_EQ(packet_of(recording, 16), "{0;100}");
  RecordingOptions options;
  options.confidence_min = 0.1;
  EXPECT_EQ(read_rows(rows, options).found.lost, 10U);
}

TEST(Recording, EmptyCellsAndNanAreNoDataAndNotZero) {
  const auto recording = read_rows(row(1, "0.0") + row(2, "0.1", kNoData) +
                                   row(3, "0.2", "nan,NaN,-nan,nan,nan,nan,nan"));
  EXPECT_EQ(packet_of(recording, 1), "{12;100}");
  EXPECT_EQ(packet_of(recording, 2), "{12;100}");
  EXPECT_EQ(recording.found.lost, 0U) << "the head is still known";
}

TEST(Recording, MostFrequentFaceIsTakenUnlessAsked) {
  const std::string rows =
      openface2_row(1, "0", "5,0,0,0,0,0,0", "7") + openface2_row(1, "0", kSmile, "3") +
      openface2_row(2, "0.1", kSmile, "3") + openface2_row(3, "0.2", "5,0,0,0,0,0,0", "7") +
      openface2_row(3, "0.2", kSmile, "3");
  const auto recording = read_rows(rows);
  ASSERT_EQ(recording.found.faces.size(), 2U);
  EXPECT_EQ(recording.found.face, 3);
  EXPECT_EQ(packet_of(recording, 0), "{12;100}");
  RecordingOptions options;
  options.face = 7;
  EXPECT_EQ(packet_of(read_rows(rows, options), 0), "{1;200}");
  options.face = 4;
  const Error error = error_of(kOpenFace2Header + rows, options);
  EXPECT_EQ(error.kind, ErrorKind::Usage);
  EXPECT_EQ(error.message, "f.csv: there is no face 4; the most frequent one is 3");
}

/// Rows of three faces: 0 all the time, 1 from the third picture on, 2 never sure.
std::string three_faces() {
  std::string text = "frame,face_id,timestamp,confidence,success,AU12_r\n";
  const auto row = [&text](int frame, int face, const char* rest) {
    text += std::to_string(frame) + "," + std::to_string(face) + ",0." + std::to_string(frame) +
            "," + rest + "\n";
  };
  for (int frame = 0; frame < 5; ++frame) {
    row(frame, 2, "0.1,0,5");
    row(frame, 0, frame < 3 ? "0.9,1,1" : "0.9,1,2");
    if (frame >= 2 && frame < 4) row(frame, 1, "0.9,1,5");
  }
  return text;
}

TEST(Recording, AllFacesAreStreamsOnOneClock) {
  RecordingOptions options;
  options.all_faces = true;
  const auto faces = read_faces(three_faces(), "f", options);
  ASSERT_TRUE(faces) << faces.error().message;
  ASSERT_EQ(faces->size(), 2U);
  EXPECT_EQ(faces->at(0).found.face, 0);
  EXPECT_EQ(protocol::format_stream_file(faces->at(0).stream),
            "Beg_Stream\n12:20;100\n12:20;100\n12:20;100\n12:40;100\n12:40;100\nEnd_Stream\n");
  // Face 1 comes two pictures later: neutral until then, so that the places agree.
  EXPECT_EQ(faces->at(1).found.face, 1);
  EXPECT_EQ(protocol::format_stream_file(faces->at(1).stream),
            "Beg_Stream\n0;200\n12;200\n12;100\nEnd_Stream\n");
  EXPECT_NE(found_lines(faces->at(1).found).find("face 1 in 2 rows (this one)"), std::string::npos);
}

TEST(Recording, AFaceWhoseFirstRowHasNoTimeComesLateToo) {
  std::string text = three_faces();
  const std::string row = "2,1,0.2,";
  text.replace(text.find(row), row.size(), "2,1,,");
  RecordingOptions options;
  options.all_faces = true;
  const auto faces = read_faces(text, "f", options);
  ASSERT_TRUE(faces) << faces.error().message;
  ASSERT_EQ(faces->size(), 2U);
  EXPECT_EQ(protocol::format_stream_file(faces->at(1).stream),
            "Beg_Stream\n0;300\n12;300\nEnd_Stream\n");
}

TEST(Recording, AFaceThatIsSeenAtOneTimeOnlyCostsTheOthersNothing) {
  const char* const one_and_two =
      "frame,face_id,timestamp,confidence,success,AU12_r\n"
      "1,0,0.0,0.98,1,2\n1,1,0.0,0.9,1,2\n2,1,0.0003,0.9,1,2\n2,0,0.1,0.98,1,3\n3,0,0.2,0.98,1,1\n";
  RecordingOptions options;
  options.all_faces = true;
  const auto faces = read_faces(one_and_two, "f", options);
  ASSERT_TRUE(faces) << faces.error().message;
  ASSERT_EQ(faces->size(), 1U);
  EXPECT_EQ(faces->front().found.face, 0);
  const auto none = read_faces(
      "frame,face_id,timestamp,confidence,success,AU12_r\n"
      "1,0,0,0.98,1,2\n1,1,0,0.9,1,2\n2,0,0,0.98,1,3\n2,1,0,0.9,1,2\n",
      "f", options);
  ASSERT_FALSE(none) << "nor do several make a recording of them";
  EXPECT_NE(none.error().message.find("no row has a later time"), std::string::npos);
}

TEST(Recording, EachOfAllFacesIsWhatFaceIdGives) {
  RecordingOptions all;
  all.all_faces = true;
  const auto faces = read_faces(three_faces(), "f", all);
  ASSERT_TRUE(faces);
  RecordingOptions one;
  one.face = 0;
  const auto alone = read_recording(three_faces(), "f", one);
  ASSERT_TRUE(alone);
  EXPECT_EQ(faces->front().stream.keyframes, alone->stream.keyframes);
}

TEST(Recording, AppendedRecordingsOfSeveralFacesStayTogether) {
  const std::string first = three_faces();
  RecordingOptions options;
  options.all_faces = true;
  const auto faces = read_faces(first + first, "f", options);
  ASSERT_TRUE(faces) << faces.error().message;
  // The second one begins 0.1 s after the first; face 1 is there 0.2 s after each beginning.
  EXPECT_EQ(protocol::media_ms(faces->at(0).stream, 0), 100U + 900U);
  std::uint64_t place = 0;
  std::vector<std::uint64_t> full;
  for (const auto& keyframe : faces->at(1).stream.keyframes) {
    place += *keyframe.time_ms;
    if (keyframe.terms == std::vector<AuTerm>{{12, Side::Both, 100}}) full.push_back(place);
  }
  const std::uint64_t begin = *faces->at(1).stream.keyframes.front().time_ms;
  EXPECT_EQ(full.front(), begin + 200);
  EXPECT_EQ(full.back(), begin + 800);
}

TEST(Recording, AManyFacedRecordingIsLimited) {
  std::string text = "frame,face_id,timestamp,confidence,success,AU12_r\n";
  for (int face = 0; face < 100; ++face) {
    text += "1," + std::to_string(face) + ",0,1,1,1\n";
  }
  RecordingOptions options;
  options.all_faces = true;
  const auto faces = read_faces(text, "f", options);
  ASSERT_TRUE(faces);
  EXPECT_EQ(faces->size(), kFacesReadMax);
}

TEST(Recording, FacesWithoutNamesAreCountedWithinThePicture) {
  RecordingOptions options;
  options.fps = 10;
  const std::string text =
      "frame,FaceScore,AU12\n0,0.9,1\n0,0.9,0.5\n1,0.9,1\n2,0.9,1\n2,0.9,0.25\n";
  const auto first = read_recording(text, "f.csv", options);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->found.faces.size(), 2U);
  EXPECT_EQ(first->stream.keyframes.size(), 3U);
  options.face = 1;
  const auto second = read_recording(text, "f.csv", options);
  ASSERT_TRUE(second);
  EXPECT_EQ(packet_of(*second, 0), "{12:50;200}");
}

TEST(Recording, TruncatedLastLineIsLeftOutAndSaid) {
  const auto recording = read_rows(row(1, "0") + row(2, "0.1") + "3,0,0.2,0.9");
  EXPECT_EQ(recording.stream.keyframes.size(), 2U);
  EXPECT_TRUE(recording.found.truncated);
  EXPECT_NE(found_sentence(recording.found).find("the truncated last line left out"),
            std::string::npos);
}

TEST(Recording, AppendedRecordingFollowsTheFirst) {
  const auto recording =
      read_rows(row(1, "0") + row(2, "0.1") + kOpenFace2Header + row(1, "0") + row(2, "0.2"));
  EXPECT_EQ(recording.found.headers, 1U);
  EXPECT_EQ(recording.found.left_out, 0U);
  ASSERT_EQ(recording.stream.keyframes.size(), 4U);
  EXPECT_EQ(recording.stream.keyframes[2].time_ms, 100U) << "one step later";
  EXPECT_EQ(recording.stream.keyframes[3].time_ms, 200U);
}

TEST(Recording, RepeatedHeaderWithinOneClockChangesNothing) {
  const auto recording = read_rows(row(1, "0") + kOpenFace2Header + row(2, "0.1"));
  EXPECT_EQ(recording.stream.keyframes[1].time_ms, 100U);
}

TEST(Recording, RowsThatAreNotLaterAreLeftOut) {
  const auto recording = read_rows(row(1, "0") + row(2, "0.1") + row(3, "0.05") + row(4, "0.1") +
                                   row(5, "") + row(6, "0.2"));
  EXPECT_EQ(recording.found.left_out, 3U);
  EXPECT_EQ(protocol::media_ms(recording.stream, 250), 300U);
}

TEST(Recording, BadCellsAreRefusedWithTheirPlaceButOnlyThoseThatAreRead) {
  const Error error =
      error_of(kOpenFace2Header + row(1, "0", "x,0,0,0,0,0,0") + row(2, "soon", "0,0,0,0,0,0,0"));
  EXPECT_EQ(error.kind, ErrorKind::BadData);
  EXPECT_EQ(error.message,
            "f.csv:2:73: 'x' in AU01_r is not a number\n"
            "f.csv:3:5: 'soon' in timestamp is not a number");
  EXPECT_TRUE(read_recording("timestamp,x_0,note,AU01_r\n0,?,hello,1\n1,?,!,1\n", "f", {}));
}

TEST(Recording, ColumnsMissingInARowAreRefused) {
  const Error error = error_of(std::string(kOpenFace2Header) + "1,0,0.0\n" + row(2, "0.1"));
  EXPECT_EQ(error.message, "f.csv:2:1: the row has 3 cells, the header names 26");
}

TEST(Recording, DecimalCommas) {
  const auto recording =
      read_recording("timestamp;success;AU01_r\n0,0;1;2,5\n0,04;1;5,0\n", "f.csv", {});
  ASSERT_TRUE(recording);
  EXPECT_EQ(packet_of(*recording, 0), "{1:50;40}");
  const Error error = error_of("timestamp,success,AU01_r\n0,0,1,2,5\n");
  EXPECT_NE(error.message.find("the row has 5 cells, the header names 3; numbers with commas"),
            std::string::npos)
      << error.message;
}

TEST(Recording, MissingOrConstantTimesNeedAnOption) {
  const Error none = error_of("frame,FaceScore,AU12\n0,1,1\n1,1,1\n");
  EXPECT_EQ(none.kind, ErrorKind::Usage);
  EXPECT_EQ(none.message,
            "f.csv: Py-Feat 1 wrote no times here; say how many pictures a second there are, such "
            "as --fps 30");
  const std::string images = kOpenFace2Header + row(1, "0") + row(2, "0") + row(3, "0");
  const Error constant = error_of(images);
  EXPECT_EQ(constant.kind, ErrorKind::Usage);
  EXPECT_NE(constant.message.find("no row has a later time than the first"), std::string::npos);
  RecordingOptions options;
  options.fps = 25;
  const auto recording = read_recording(images, "f.csv", options);
  ASSERT_TRUE(recording);
  EXPECT_EQ(protocol::media_ms(recording->stream, 250), 120U);
}

TEST(Recording, WhatIsNoRecordingIsRefused) {
  EXPECT_EQ(error_of(kOpenFace2Header).message, "f.csv:1:1: the recording has no rows");
  EXPECT_TRUE(error_of("a,b,c\n1,2,3\n")
                  .message.starts_with("f.csv:1:1: a table whose columns are of no recogniser"));
  EXPECT_EQ(error_of("").kind, ErrorKind::BadData);
  EXPECT_EQ(error_of(kOpenFace2Header + row(1, "0") + row(2, "1e6")).message,
            "f.csv:3:1: the time jumps by more than a day");
  EXPECT_EQ(error_of(kOpenFace2Header + row(1, "0") + row(2, "9e9") + row(3, "9.1e9")).message,
            "f.csv:3:1: the time jumps by more than a day")
      << "nothing is made of what comes after it";
}

TEST(Recording, TimesInMicrosecondsAreToldApartFromFacesThatAreNotSeen) {
  const Error error =
      error_of(kOpenFace2Header + row(1, "1700000000000000") + row(2, "1700000000033333"));
  EXPECT_EQ(error.kind, ErrorKind::BadData);
  EXPECT_EQ(error.message,
            "f.csv: no row has a time of at most 10000000000 s: it may be told in microseconds; "
            "say how many pictures a second there are, such as --fps 30");
}

TEST(Recording, RowsThatWereLeftOutAreToldInTheSentenceToo) {
  const auto recording = read_rows(row(1, "0.5") + row(2, "0.5") + row(3, "0.6"));
  EXPECT_NE(found_sentence(recording.found).find(", 1 left out (no later time)"), std::string::npos)
      << found_sentence(recording.found);
}

TEST(Recording, ReportSaysWhatWasFound) {
  const auto recording =
      read_rows(row(1, "0.5") + row(2, "0.6") + kOpenFace2Header + row(3, "3.0") + "4,0");
  EXPECT_EQ(found_lines(recording.found),
            "  format      OpenFace 2\n"
            "  scale       0-5, largest 5.00\n"
            "  people      1: face 0 in 3 rows (taken)\n"
            "  rows        3, 0 of them no data, 0 left out (no later time)\n"
            "  gaps        1 over 0.5 s, the longest 2.40 s\n"
            "  appended    1 header line in the middle\n"
            "  truncated   the last line has no end and was left out\n");
}

TEST(Recording, AnyTextCutAnywhereIsAnErrorOrALegalStream) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const std::string whole = kOpenFace2Header + row(1, "0") + row(2, "0.1", kNoData) +
                            kOpenFace2Header + row(1, "0") + row(2, "3.1");
  for (int round = 0; round < 2000; ++round) {
    std::string text = whole.substr(
        0, static_cast<std::size_t>(seeded.integer(0, static_cast<int>(whole.size()))));
    if (!text.empty() && seeded.chance(0.7)) {
      const auto at =
          static_cast<std::size_t>(seeded.integer(0, static_cast<int>(text.size()) - 1));
      text[at] = static_cast<char>(seeded.integer(0, 255));
    }
    const auto recording = read_recording(text, "f.csv", {});
    if (!recording) {
      ASSERT_TRUE(recording.error().message.starts_with("f.csv")) << recording.error().message;
      continue;
    }
    const std::string stream = protocol::format_stream_file(recording->stream);
    const auto again = protocol::parse_stream_file(stream, "f.txt");
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_EQ(protocol::format_stream_file(*again), stream);
  }
}

TEST(Recording, AClockThatNoCameraHasIsSaid) {
  const std::string rows = row(1, "0.001") + row(2, "0.002") + row(3, "0.003");
  const Recording hasty = read_rows(rows);
  const std::string said = "1000 rows a second are no camera's: --fps says how many";
  EXPECT_NE(found_sentence(hasty.found).find(said), std::string::npos);
  EXPECT_NE(found_lines(hasty.found).find("clock       " + said), std::string::npos);
  EXPECT_EQ(warnings(hasty.found), std::vector<std::string>{said});
  EXPECT_EQ(
      warnings(hasty.found, {"Pictures/s", "Neutral"}),
      std::vector<std::string>{"1000 rows a second are no camera's: Pictures/s says how many"});
  RecordingOptions thirty;
  thirty.fps = 30;
  EXPECT_EQ(found_sentence(read_rows(rows, thirty).found).find("no camera"), std::string::npos);
}

TEST(Recording, AClockThatStoodStillIsToldWithTheRateThatReadsEveryRow) {
  std::string rows;
  for (int frame = 0; frame < 610; ++frame) {
    // A hundred rows have the time of the first of them.
    const int shown = frame < 200 ? frame : std::max(200, frame - 100);
    rows += row(frame + 1, std::to_string(shown / 60.0));
  }
  const auto recording = read_rows(rows);
  EXPECT_EQ(recording.found.left_out, 100U);
  EXPECT_EQ(warnings(recording.found),
            std::vector<std::string>{"100 rows without a later time: --fps 60 reads them all"});
  EXPECT_NE(found_lines(recording.found)
                .find("610, 0 of them no data, 100 left out (no later time); --fps 60 reads them "
                      "all\n"),
            std::string::npos)
      << found_lines(recording.found);
  RecordingOptions options;
  options.fps = 60;
  EXPECT_EQ(read_rows(rows, options).found.left_out, 0U);
}

}  // namespace
}  // namespace aucast::sources
