// Live sources byte by byte, with damage of every kind.
#include "common/sources/live_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "tests/support/steady_time.h"
#include "tests/unit/sources/tables.h"

namespace aucast::sources {
namespace {

using test::at_second;

using tables::kOpenFace2Header;
using tables::openface2_row;

Result<ArkitTable> no_curves() {
  return Error{ErrorKind::Unreadable, "arkit_to_au.csv: cannot be read"};
}

Result<ArkitTable> jaw_only() {
  return ArkitTable{{{"jawOpen", 26, Side::Both, 1}}};
}

/// A row at `ms` that says only AU 12, of 0 to 5.
std::string smile(int frame, const std::string& seconds, const std::string& of_five) {
  return openface2_row(frame, seconds, "0," + of_five + ",0,0,0,0,0");
}

class LiveReaderTest : public ::testing::Test {
 protected:
  void start(LiveOptions options = {}, LoadCurves curves = no_curves) {
    reader_.emplace("face.csv", std::move(options), std::move(curves));
  }

  /// The keyframes as text, as they are on a stream file's line.
  std::vector<std::string> keyframes() {
    std::vector<std::string> texts;
    for (const LiveKeyframe& keyframe : reader_->take_keyframes()) {
      texts.push_back(protocol::encode(keyframe.keyframe));
    }
    return texts;
  }

  std::string messages() {
    std::string all;
    for (const LiveMessage& message : reader_->take_messages()) all += message.text + "\n";
    return all;
  }

  std::vector<std::string> fed(std::string_view bytes, double now = 0) {
    reader_->feed(bytes, at_second(now));
    return keyframes();
  }

  std::optional<LiveReader> reader_;
};

using Texts = std::vector<std::string>;

TEST_F(LiveReaderTest, ARowIsAKeyframeAsSoonAsItsLineEnds) {
  start();
  EXPECT_EQ(fed(kOpenFace2Header), Texts{});
  EXPECT_EQ(messages(), "face.csv: OpenFace 2, live, AU scale 0-5\n");
  EXPECT_EQ(fed(smile(1, "0.000", "1")), Texts{"{12:20;40}"});
  EXPECT_EQ(fed(smile(2, "0.033", "2")), Texts{"{12:40;33}"});
  EXPECT_EQ(fed(smile(3, "0.067", "3")), Texts{"{12:60;34}"});
}

TEST_F(LiveReaderTest, BytesMayComeInAnyPieces) {
  const std::string text =
      std::string(kOpenFace2Header) + smile(1, "0.000", "1") + smile(2, "0.040", "2");
  for (std::size_t size = 1; size < 40; ++size) {
    start();
    Texts all;
    for (std::size_t at = 0; at < text.size(); at += size) {
      for (const std::string& keyframe : fed(text.substr(at, size))) all.push_back(keyframe);
    }
    EXPECT_EQ(all, (Texts{"{12:20;40}", "{12:40;40}"})) << size;
  }
}

TEST_F(LiveReaderTest, ATruncatedLineWaitsForItsRest) {
  start();
  const std::string row = smile(1, "0.000", "1");
  EXPECT_EQ(fed(kOpenFace2Header + row.substr(0, 20)), Texts{});
  EXPECT_EQ(fed(row.substr(20)), Texts{"{12:20;40}"});
}

TEST_F(LiveReaderTest, ALineWithoutItsEndIsLeftOutWhenTheWriterGoes) {
  start();
  const std::string row = smile(2, "0.040", "2");
  static_cast<void>(fed(kOpenFace2Header + smile(1, "0.000", "1") + row.substr(0, 20)));
  static_cast<void>(messages());
  reader_->end_input(at_second(1));
  EXPECT_EQ(messages(), "face.csv: the last line has no end and was left out\n");
  EXPECT_EQ(fed(smile(3, "0.080", "3"), 1), Texts{"{12:60;40}"});
}

TEST_F(LiveReaderTest, AHeaderInTheMiddleBeginsAnotherRecordingOnTheSameFace) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "5.000", "1") + smile(2, "5.030", "2")));
  static_cast<void>(messages());
  const auto keyframes = fed(kOpenFace2Header + smile(1, "0.000", "3") + smile(2, "0.050", "4"));
  EXPECT_EQ(keyframes, (Texts{"{12:60;30}", "{12:80;50}"}));
  EXPECT_EQ(messages(), "face.csv:4: the header once more: another recording begins\n");
}

TEST_F(LiveReaderTest, AHeaderOfAnotherFormatInTheMiddleIsUnderstood) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "5.000", "1")));
  static_cast<void>(messages());
  EXPECT_EQ(fed(tables::kFacsvatar, 1).size(), 2U);
  EXPECT_EQ(messages(), "face.csv: FACSvatar, live, AU scale 0-1\n");
  EXPECT_EQ(fed("Beg_Stream\n6:50;20\nEnd_Stream\n", 2), Texts{"{6:50;20}"});
}

TEST_F(LiveReaderTest, SpacedHeadersOfVersionOneAreUnderstood) {
  start();
  EXPECT_EQ(fed(tables::kOpenFace1).size(), 2U);
  EXPECT_EQ(messages(), "face.csv: OpenFace 1, live, AU scale 0-5\n");
}

TEST_F(LiveReaderTest, EveryTableOfARecogniserIsUnderstood) {
  for (const char* table :
       {tables::kFacsvatar, tables::kLibreFace, tables::kFacet, tables::kAffdex}) {
    start();
    EXPECT_GE(fed(table).size(), 2U) << table;
    EXPECT_EQ(messages().find("left out"), std::string::npos) << table;
  }
  for (const char* table : {tables::kPyFeat1, tables::kPyFeat2}) {
    start();
    EXPECT_EQ(fed(table).size(), 2U) << table;
    LiveOptions options;
    options.recording.fps = 30;
    start(options);
    EXPECT_EQ(fed(table).size(), 2U) << table;
  }
  start();
  EXPECT_EQ(fed(tables::kFaceReader).size(), 3U);
  EXPECT_EQ(messages(), "face.csv: FaceReader, live, AU scale 0-1\n");
  for (const char* table : {tables::kLiveLinkFace, tables::kMediaPipe}) {
    start({}, jaw_only);
    EXPECT_EQ(fed(table).size(), 2U) << table;
  }
}

TEST_F(LiveReaderTest, LiveLinkFaceSaysWhenItsTableIsMissing) {
  start();
  EXPECT_EQ(fed(tables::kLiveLinkFace), Texts{});
  EXPECT_NE(messages().find("arkit_to_au.csv: cannot be read"), std::string::npos);
}

/// Rows of Live Link Face, `rate` a second, whose timecode counts `counted` frames a second.
std::string live_link_face(int rows, int rate, int counted) {
  std::string text = "Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen\n";
  for (int row = 0; row < rows; ++row) {
    const int frames = counted / 5 + row * (counted / rate);
    std::array<char, 48> line{};
    std::snprintf(line.data(), line.size(), "01:00:%02d:%02d.250,61,0,0.5\n", frames / counted,
                  frames % counted);
    text += line.data();
  }
  return text;
}

TEST_F(LiveReaderTest, LiveLinkFaceLosesNoRowWhileItsFramesAreCounted) {
  for (const auto& [rate, counted] : {std::pair{60, 60}, {30, 60}, {30, 30}, {25, 25}}) {
    start({}, jaw_only);
    const Texts all = fed(live_link_face(5 * rate, rate, counted));
    EXPECT_EQ(all.size(), static_cast<std::size_t>(5 * rate)) << rate << " of " << counted;
    EXPECT_EQ(messages().find("left out"), std::string::npos) << rate << " of " << counted;
    const int step = static_cast<int>(std::lround(1000.0 / rate));
    const int last = std::stoi(all.back().substr(all.back().find(';') + 1));
    EXPECT_NEAR(last, step, 3) << "settled";
  }
}

TEST_F(LiveReaderTest, LiveLinkFaceOfAHigherRateGoesOnAfterASecond) {
  start({}, jaw_only);
  static_cast<void>(fed(live_link_face(2 * 120, 120, 120)));
  static_cast<void>(messages());
  const std::string later = live_link_face(5 * 120, 120, 120);
  std::size_t at = 0;
  for (int line = 0; line < 1 + 2 * 120; ++line) at = later.find('\n', at) + 1;
  EXPECT_EQ(fed(later.substr(at)).size(), 3U * 120U);
}

TEST_F(LiveReaderTest, ARowThatIsNotUnderstoodIsLeftOutAndSaid) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "0.000", "1")));
  static_cast<void>(messages());
  EXPECT_EQ(fed("1,2,3\n"), Texts{});
  EXPECT_EQ(messages(),
            "face.csv:3:1: the row has 3 cells, the header names 26; the row was left out\n");
  EXPECT_EQ(fed(smile(3, "0.040", "high")), Texts{});
  EXPECT_NE(messages().find(": 'high' in AU12_r is not a number; the row was left out"),
            std::string::npos);
  EXPECT_EQ(fed(smile(4, "0.080", "2,5")), Texts{});
  EXPECT_NE(messages().find("numbers with commas must be quoted, or the cells separated by ';'"),
            std::string::npos);
  EXPECT_EQ(fed(smile(4, "0.080", "\"2,5\"")), Texts{"{12:50;80}"});
  EXPECT_EQ(messages(), "");
}

TEST_F(LiveReaderTest, MissingColumnsAndNaNAreNoData) {
  start();
  EXPECT_EQ(fed("timestamp,success,AU12_r,AU04_r\n0,1,5,5\n"), Texts{"{4,12;40}"});
  EXPECT_EQ(fed("0.1,1,nan,2.5\n0.2,1,,2.5\n"), (Texts{"{4:50,12;100}", "{4:50,12;100}"}));
}

TEST_F(LiveReaderTest, AFloodOfMistakesIsNotSaidWhole) {
  start();
  static_cast<void>(fed(kOpenFace2Header));
  static_cast<void>(messages());
  for (int row = 0; row < 1000; ++row) static_cast<void>(fed("1,2\n"));
  EXPECT_EQ(reader_->take_messages().size(), LiveReader::kSaidMax + 1);
  EXPECT_EQ(fed(smile(3, "0.040", "1")), Texts{"{12:20;40}"});
}

TEST_F(LiveReaderTest, AnEndlessLineTakesNoMemoryAndIsLeftOut) {
  start();
  static_cast<void>(fed(kOpenFace2Header));
  static_cast<void>(messages());
  const std::string piece(65536, '1');
  for (int i = 0; i < 64; ++i) EXPECT_EQ(fed(piece), Texts{});
  EXPECT_EQ(fed("\n" + smile(1, "0", "1")), Texts{"{12:20;40}"});
  EXPECT_NE(messages().find("face.csv:2:262145: the line is longer than 262144 bytes"),
            std::string::npos);
}

TEST_F(LiveReaderTest, ANewBeginningGoesOnFromTheLastMoment) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "7.000", "1") + smile(2, "7.050", "1")));
  reader_->restart();
  static_cast<void>(messages());
  EXPECT_EQ(fed(kOpenFace2Header + smile(1, "0.000", "2") + "1,2\n"), Texts{"{12:40;50}"});
  EXPECT_NE(messages().find("face.csv:3:1: the row has 2 cells"), std::string::npos);
}

TEST_F(LiveReaderTest, RowsThatAreNotLaterAreLeftOut) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "0.040", "1")));
  EXPECT_EQ(fed(smile(2, "0.040", "2") + smile(3, "0.020", "2")), Texts{});
  EXPECT_NE(messages().find("face.csv:3: the row's time is not later"), std::string::npos);
}

TEST_F(LiveReaderTest, OneTimeFarAheadSilencesNobodyForLong) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "0.000", "1") + smile(2, "0.040", "1")));
  static_cast<void>(fed(smile(3, "1000000.000", "2")));
  int frame = 4;
  const auto row = [&frame] {
    const std::string seconds = std::to_string(0.04 * frame);
    return smile(frame++, seconds, "3");
  };
  for (std::size_t i = 1; i < LiveReader::kRefusalsMax; ++i) EXPECT_EQ(fed(row()), Texts{}) << i;
  static_cast<void>(messages());
  EXPECT_EQ(fed(row()), Texts{"{12:60;40}"});
  EXPECT_NE(messages().find("the source's clock was set; it goes on from here"), std::string::npos);
  EXPECT_EQ(fed(row()), Texts{"{12:60;40}"});
  EXPECT_EQ(messages(), "");
}

TEST_F(LiveReaderTest, AClockThatIsSetBackGoesOn) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "7200.000", "1") + smile(2, "7200.040", "1")));
  std::size_t shown = 0;
  for (int frame = 3; frame < 43; ++frame) {
    reader_->feed(smile(frame, std::to_string(3600 + 0.04 * frame), "2"), at_second(0.04 * frame));
    for (const LiveKeyframe& keyframe : reader_->take_keyframes()) {
      EXPECT_EQ(keyframe.begins, shown == 0);
      ++shown;
    }
  }
  EXPECT_EQ(shown, 41 - LiveReader::kRefusalsMax);
}

TEST_F(LiveReaderTest, OldRowsInAnyOrderSetNoClock) {
  start();
  static_cast<void>(fed(kOpenFace2Header + smile(1, "0.000", "1") + smile(2, "10.000", "1")));
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(fed(smile(3, i % 5 == 0 ? "4.000" : "5." + std::to_string(i % 5), "2")), Texts{});
  }
  EXPECT_EQ(fed(smile(4, "10.040", "1")), Texts{"{12:20;40}"});
}

TEST_F(LiveReaderTest, ALineWithoutDurationIsAJump) {
  start();
  EXPECT_EQ(fed("1;100\n6+12;0\n4;200\n"), (Texts{"{1;100}", "{6,12;0}", "{4;200}"}));
}

TEST_F(LiveReaderTest, TheScaleGrowsWhenTheValuesSaySo) {
  start();
  static_cast<void>(fed(tables::kFacsvatar));
  static_cast<void>(messages());
  EXPECT_EQ(fed("2,0.066,0.95,1,0,0,0,0,0,2.5,0\n").back(), "{1:50;33}");
  EXPECT_NE(messages().find("face.csv:4: AU scale 0-5 from now on"), std::string::npos);
}

TEST_F(LiveReaderTest, AValueThatFitsNoScaleIsNoDataAndDoesNotChangeTheScale) {
  start();
  EXPECT_EQ(fed(kOpenFace2Header + openface2_row(1, "0.000", "4,0,0,0,0,0,0", "0")),
            Texts{"{1:80;40}"});
  EXPECT_EQ(fed(openface2_row(2, "0.040", "99999,0,0,0,0,0,0", "0")), Texts{"{1:80;40}"});
  EXPECT_NE(messages().find("face.csv:3: AU 1 is above 100"), std::string::npos);
  EXPECT_EQ(fed(openface2_row(3, "0.080", "2,0,0,0,0,0,0", "0")), Texts{"{1:40;40}"});
}

TEST_F(LiveReaderTest, TheFaceIsTheOneThatWasAskedForOrTheFirstUntilItIsGone) {
  LiveOptions options;
  options.recording.face = 1;
  start(options);
  const auto both = [](int frame, const std::string& seconds) {
    return openface2_row(frame, seconds, "0,1,0,0,0,0,0", "0") +
           openface2_row(frame, seconds, "0,2,0,0,0,0,0", "1");
  };
  EXPECT_EQ(fed(kOpenFace2Header + both(1, "0.000")), Texts{"{12:40;40}"});
  start();
  EXPECT_EQ(fed(kOpenFace2Header + both(1, "0.000")), Texts{"{12:20;40}"});
  const std::string second = openface2_row(2, "1.000", "0,2,0,0,0,0,0", "1");
  EXPECT_EQ(fed(second, 1.0), Texts{});
  EXPECT_EQ(fed(openface2_row(3, "1.600", "0,2,0,0,0,0,0", "1"), 1.6).size(), 1U);
  EXPECT_NE(messages().find("face.csv: face 1 from now on"), std::string::npos);
}

TEST_F(LiveReaderTest, EveryFaceIsSaidOnceWhenAllAreAskedFor) {
  LiveOptions options;
  options.recording.all_faces = true;
  start(options);
  static_cast<void>(fed(kOpenFace2Header));
  EXPECT_TRUE(reader_->take_new_faces().empty());
  const std::string of_seven = openface2_row(1, "0.000", "0,1,0,0,0,0,0", "7");
  const std::string of_three = openface2_row(1, "0.000", "0,2,0,0,0,0,0", "3");
  static_cast<void>(fed(of_seven + of_three));
  const auto faces = reader_->take_new_faces();
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].id, 7);
  EXPECT_EQ(faces[0].beginning, kOpenFace2Header + of_seven);
  EXPECT_EQ(faces[1].id, 3);
  EXPECT_EQ(faces[1].beginning, kOpenFace2Header + of_three);
  static_cast<void>(fed(openface2_row(2, "0.033", "0,1,0,0,0,0,0", "7")));
  EXPECT_TRUE(reader_->take_new_faces().empty());
}

TEST_F(LiveReaderTest, OfTooManyFacesTheLastAreNoNews) {
  LiveOptions options;
  options.recording.all_faces = true;
  start(options);
  static_cast<void>(fed(kOpenFace2Header));
  for (std::size_t face = 0; face < kFacesReadMax + 5; ++face) {
    static_cast<void>(fed(openface2_row(1, "0.000", "0,1,0,0,0,0,0", std::to_string(face))));
  }
  EXPECT_EQ(reader_->take_new_faces().size(), kFacesReadMax);
}

TEST_F(LiveReaderTest, RowsWithoutAClockTakeTheTimeOfTheirArrival) {
  start();
  EXPECT_EQ(fed("frame,FaceScore,AU12\n0,1,0.5\n", 10), Texts{"{12:50;40}"});
  EXPECT_EQ(fed("1,1,0.6\n", 10.1), Texts{"{12:60;100}"});
  // What comes at once was not recorded at once.
  EXPECT_EQ(fed("2,1,0.7\n3,1,0.8\n", 10.2), (Texts{"{12:70;100}", "{12:80;40}"}));
}

TEST_F(LiveReaderTest, LinesOfAStreamFileKeepTheirTimes) {
  start();
  EXPECT_EQ(fed("\xef\xbb\xbf"
                "Beg_Stream\r\n1+2;100 # brows\r\n\n{12:50}\n",
                3),
            (Texts{"{1,2;100}", "{12:50;250}"}));
  EXPECT_EQ(fed("6\n", 3.05), Texts{"{6;50}"});
  EXPECT_EQ(fed("6\n", 4), Texts{"{6;250}"});
  static_cast<void>(messages());
  EXPECT_EQ(fed("6;;\n{~6}\n"), Texts{});
  const std::string said = messages();
  EXPECT_NE(said.find("face.csv:7:3: "), std::string::npos) << said;
  EXPECT_NE(said.find("'~' is for the wire only; the line was left out"), std::string::npos);
}

TEST_F(LiveReaderTest, WhatIsNothingKnownIsSaid) {
  start();
  EXPECT_EQ(fed("hello\n"), Texts{});
  EXPECT_NE(messages().find("waiting for the names of columns"), std::string::npos);
  EXPECT_EQ(fed("name,date,place\n"), Texts{});
  EXPECT_NE(messages().find("a table whose columns are of no recogniser known here"),
            std::string::npos);
  EXPECT_EQ(fed(kOpenFace2Header + smile(1, "0", "1")).size(), 1U);
}

TEST_F(LiveReaderTest, SilenceHoldsThenLeadsToNeutral) {
  start();
  EXPECT_FALSE(reader_->idle_due().has_value());
  static_cast<void>(fed(kOpenFace2Header + smile(1, "0.000", "5"), 100));
  EXPECT_EQ(reader_->idle_due(), at_second(100.5));
  reader_->idle(at_second(100.49));
  EXPECT_EQ(keyframes(), Texts{});
  Texts eased;
  while (const auto due = reader_->idle_due()) {
    reader_->idle(*due);
    for (const std::string& keyframe : keyframes()) eased.push_back(keyframe);
  }
  EXPECT_EQ(eased, (Texts{"{12:90;100}", "{12:80;100}", "{12:70;100}", "{12:60;100}", "{12:50;100}",
                          "{12:40;100}", "{12:30;100}", "{12:20;100}", "{12:10;100}", "{0;100}"}));
  // It comes back: the pause is not played.
  EXPECT_EQ(fed(smile(2, "20.000", "5"), 120), Texts{"{12;40}"});
}

TEST_F(LiveReaderTest, AStreamFilesLineHoldsUntilItsInputEnds) {
  start();
  static_cast<void>(fed("12;100\n", 100));
  EXPECT_FALSE(reader_->idle_due().has_value());
  reader_->end_input(at_second(200));
  EXPECT_EQ(reader_->idle_due(), at_second(200.5));
}

TEST_F(LiveReaderTest, ARateLeavesMomentsOut) {
  LiveOptions options;
  options.rate = 10;
  start(options);
  std::string text = kOpenFace2Header;
  for (int frame = 0; frame < 30; ++frame) {
    const int ms = frame * 1000 / 30;
    text += smile(frame, "0." + std::to_string(1000 + ms).substr(1), "5");
  }
  const Texts all = fed(text);
  EXPECT_EQ(all.size(), 10U);
  EXPECT_EQ(all.back(), "{12;100}");
}

TEST_F(LiveReaderTest, AClockThatStandsStillDoesNotFillTheLog) {
  start();
  std::string rows = kOpenFace2Header + smile(1, "0.000", "1");
  for (int frame = 2; frame < 1000; ++frame) rows += smile(frame, "0.000", "1");
  static_cast<void>(fed(rows));
  EXPECT_EQ(reader_->take_messages().size(), LiveReader::kSaidMax + 2)
      << "with the table and an end";
}

TEST_F(LiveReaderTest, HeadersInTurnDoNotFillTheLog) {
  start();
  const std::string table = tables::kFacsvatar;
  const std::string header = table.substr(0, table.find('\n') + 1);
  std::string other = header;
  other.replace(other.find("AU45"), 4, "AU12");
  std::string rows;
  for (int turn = 0; turn < 1000; ++turn) {
    // Either is of 0 to 1 until a value says otherwise.
    const std::string row = std::to_string(turn) + ",0.95,1,0,0,0,0,0,2.5,0\n";
    rows += header;
    rows += "1," + row;
    rows += other;
    rows += "1," + row;
  }
  static_cast<void>(fed(rows));
  const std::string said = messages();
  EXPECT_NE(said.find("AU scale 0-5 from now on"), std::string::npos);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), LiveReader::kSaidMax + 2)
      << "with the first table and an end";
}

TEST_F(LiveReaderTest, FacesInTurnDoNotFillTheLog) {
  start();
  static_cast<void>(fed(kOpenFace2Header));
  for (int face = 0; face < 1000; ++face) {
    const int seconds = 10 * face;
    static_cast<void>(fed(openface2_row(face, std::to_string(seconds) + ".000", "0,1,0,0,0,0,0",
                                        std::to_string(face)),
                          seconds));
  }
  EXPECT_EQ(reader_->take_messages().size(), LiveReader::kSaidMax + 2)
      << "with the table and an end";
}

TEST_F(LiveReaderTest, AGoodRowBetweenBadOnesEndsNoRunOfComplaints) {
  start();
  std::string rows = kOpenFace2Header;
  for (int frame = 1; frame < 300; ++frame) {
    const std::string row = smile(frame, std::to_string(frame) + ".000", "1");
    rows += row + row;
  }
  static_cast<void>(fed(rows));
  EXPECT_EQ(reader_->take_messages().size(), LiveReader::kSaidMax + 2)
      << "with the table and an end";
  rows.clear();
  for (int frame = 300; frame < 401; ++frame)
    rows += smile(frame, std::to_string(frame) + ".000", "1");
  static_cast<void>(fed(rows));
  EXPECT_EQ(fed("1,2\n"), Texts{});
  EXPECT_EQ(reader_->take_messages().size(), 1U) << "after a hundred good ones it is news again";
}

TEST_F(LiveReaderTest, LabelsOfDatabasesAreNamed) {
  start();
  EXPECT_EQ(fed("1,0\n2,0\n3,5\n"), Texts{}) << "as in a recording, none of them is an AU";
  EXPECT_TRUE(
      messages().starts_with("face.csv:1:1: this seems to be a label file of DISFA or BP4D"));
  EXPECT_EQ(fed("4,5\n"), Texts{});
}

TEST_F(LiveReaderTest, LabelsThatComeOneByOneAreNamedAtTheThird) {
  start();
  EXPECT_EQ(fed("1,0\n"), Texts{"{1;250}"}) << "an AU that somebody sends is not kept waiting";
  EXPECT_EQ(fed("2,0\n", 0.1), Texts{"{2;100}"});
  EXPECT_EQ(fed("3,5\n", 0.2), Texts{});
  EXPECT_NE(messages().find("face.csv:3:1: this seems to be a label file of DISFA or BP4D"),
            std::string::npos);
  EXPECT_EQ(fed("4,5\n", 0.3), Texts{});
}

TEST_F(LiveReaderTest, WhichWayANodGoesIsSaidWhenTheLandmarksTell) {
  start();
  std::string rows = "frame,FaceScore,x_27,x_30,x_33,y_27,y_30,y_33,Pitch,Roll,Yaw,AU01,valence\n";
  for (int frame = 0; frame < 12; ++frame) {
    rows += std::to_string(frame) + ",0.9,100,100,100,100," + std::to_string(135 + frame) +
            ",150,0." + std::to_string(10 + frame) + ",0,0,0,0\n";
  }
  static_cast<void>(fed(rows));
  EXPECT_EQ(
      messages(),
      "face.csv: Py-Feat 2 (pose in radians, positive pitch up as documented), live, AU scale "
      "0-1\n"
      "face.csv:11: pose in radians, positive pitch down as the landmarks say from now on\n");
}

}  // namespace
}  // namespace aucast::sources
