// Every dialect by a tiny table of its own: which it is, what its numbers mean.
#include <gtest/gtest.h>

#include "common/sources/content.h"
#include "common/sources/found_report.h"
#include "common/sources/recording.h"
#include "protocol/codec.h"
#include "tests/support/read_recording.h"
#include "tests/unit/sources/tables.h"

namespace aucast::sources {
namespace {

using namespace tables;

const ArkitTable kCurves = {{{"eyeBlinkLeft", 45, Side::Left, 1},
                             {"eyeBlinkRight", 45, Side::Right, 1},
                             {"eyeLookInLeft", 62, Side::Left, 1},
                             {"jawOpen", 26, Side::Both, 1},
                             {"jawLeft", 30, Side::Left, 1},
                             {"jawRight", 30, Side::Right, 1},
                             {"mouthSmileLeft", 12, Side::Left, 1},
                             {"mouthSmileRight", 12, Side::Right, 1},
                             {"notThere", 1, Side::Both, 1}}};

Recording read(const std::string& text, const RecordingOptions& options = {}) {
  auto recording =
      read_recording(text, "f.csv", options, {}, [] { return Result<ArkitTable>(kCurves); });
  if (!recording) {
    ADD_FAILURE() << recording.error().message;
    return {};
  }
  return std::move(*recording);
}

std::string packet(const Recording& recording, std::size_t index) {
  if (index >= recording.stream.keyframes.size()) return "no such keyframe";
  return protocol::encode(recording.stream.keyframes[index]);
}

RecordingOptions at_fps(double fps) {
  RecordingOptions options;
  options.fps = fps;
  return options;
}

TEST(OpenFace2, IntensitiesAreOfFiveAndPresenceCompletesThem) {
  const auto recording = read(kOpenFace2Header + openface2_row(1, "0.000", "2.5,0,0,1,0,1.0,0") +
                              openface2_row(2, "0.033", "0,5,4.99,1,1.00,0.0,1"));
  EXPECT_EQ(recording.found.format, "OpenFace 2");
  EXPECT_EQ(recording.found.scale, 5);
  EXPECT_EQ(packet(recording, 0), "{1:50,28:50;33}");
  EXPECT_EQ(packet(recording, 1), "{12,45;33}") << "AU12_c and AU45_c add nothing to _r";
}

TEST(OpenFace2, ANeutralFaceKeepsTheScaleOfTheFormat) {
  const auto recording = read(kOpenFace2Header + openface2_row(1, "0.000", "0.5,0,0,1,0,0,0") +
                              openface2_row(2, "0.033", "0.25,0,0,1,0,0,0"));
  EXPECT_EQ(recording.found.scale, 5);
  EXPECT_EQ(packet(recording, 0), "{1:10;33}");
}

/// A row with turns: gaze_angle_x, gaze_angle_y, then pose_Rx, pose_Ry, pose_Rz.
std::string turned(const std::string& gaze, const std::string& pose) {
  const std::string header =
      "frame,face_id,timestamp,success,gaze_angle_x,gaze_angle_y,pose_Rx,"
      "pose_Ry,pose_Rz,AU01_r\n";
  return packet(read(header + "1,0,0,1," + gaze + "," + pose + ",0\n2,0,0.04,1," + gaze + "," +
                     pose + ",0\n"),
                0);
}

TEST(OpenFace2, TurnsAreTheSubjectsOwn) {
  // 17.5 degrees are half of the 35 that AU 51 stands for; the eyes go with the head's turn.
  EXPECT_EQ(turned("-0.305433,0", "0,0.305433,0"), "{52:50;40}") << "image left is subject's right";
  EXPECT_EQ(turned("0.305433,0", "0,-0.305433,0"), "{51:50;40}");
  EXPECT_EQ(turned("0,0.191986", "0.191986,0,0"), "{54:50;40}") << "a positive pitch is down";
  EXPECT_EQ(turned("0,-0.191986", "-0.191986,0,0"), "{53:50;40}");
  EXPECT_EQ(turned("0,0", "0,0,0.191986"), "{55:50;40}") << "clockwise in the image is left";
  EXPECT_EQ(turned("0,0", "0,0,-0.191986"), "{56:50;40}");
}

TEST(OpenFace2, GazeIsTakenIntoTheHead) {
  EXPECT_EQ(turned("0.244346,0", "0,0,0"), "{61:50;40}") << "image right is subject's left";
  EXPECT_EQ(turned("-0.244346,0", "0,0,0"), "{62:50;40}");
  EXPECT_EQ(turned("0,-0.191986", "0,0,0"), "{63:50;40}");
  EXPECT_EQ(turned("0,0.191986", "0,0,0"), "{64:50;40}");
  EXPECT_EQ(turned("0,0", "0,0.244346,0"), "{52:40,61:50;40}")
      << "a head turned right whose eyes stay on the camera";
}

TEST(OpenFace1, BlanksAndGazeVectors) {
  const auto recording = read(kOpenFace1);
  EXPECT_EQ(recording.found.format, "OpenFace 1");
  EXPECT_EQ(packet(recording, 0), "{1:50,28:50,61:20;40}");
  EXPECT_EQ(packet(recording, 1), "{45;40}");
}

TEST(Facsvatar, ScaleIsFoundFromTheValues) {
  const auto of_one = read(kFacsvatar);
  EXPECT_EQ(of_one.found.format, "FACSvatar");
  EXPECT_EQ(of_one.found.scale, 1);
  EXPECT_EQ(packet(of_one, 1), "{1:86,45;33}");
  std::string text = kFacsvatar;
  text.replace(text.find("0.86"), 4, "4.30");
  const auto of_five = read(text);
  EXPECT_EQ(of_five.found.scale, 5);
  EXPECT_EQ(packet(of_five, 1), "{1:86,45:20;33}");
  text.replace(text.find("4.30"), 4, "86.0");
  EXPECT_EQ(read(text).found.scale, 100);
}

TEST(PyFeat1, DegreesAndPictureNumbers) {
  const auto recording = read(kPyFeat1, at_fps(30));
  EXPECT_EQ(recording.found.format, "Py-Feat 1");
  EXPECT_EQ(recording.found.scale, 1);
  EXPECT_EQ(packet(recording, 0), "{1:25,52:50,53:50,56:50;100}");
  EXPECT_EQ(packet(recording, 1), "{1:50,43:75,54;100}") << "three pictures of 30 a second";
}

TEST(PyFeat2, RadiansAndOtherSigns) {
  const auto recording = read(kPyFeat2, at_fps(25));
  EXPECT_EQ(recording.found.format, "Py-Feat 2");
  EXPECT_EQ(packet(recording, 0), "{1:25,12:50,51:50,53:50,56:50,62:50,64:50;40}");
  EXPECT_EQ(packet(recording, 1), "{1:50,12:25;40}");
}

TEST(OpenFace2, GazeWithoutTheHeadsPoseIsNoData) {
  const std::string header =
      "frame,face_id,timestamp,success,gaze_angle_x,gaze_angle_y,pose_Rx,pose_Ry,pose_Rz,AU01_r\n";
  const auto recording = read(header + "1,0,0,1,0.1,0.2,0.3,0.2,0.1,0\n" +
                              "2,0,0.04,1,0.1,0.2,,,,0\n3,0,0.08,1,0.1,0.2,0.3,0.2,0.1,0\n");
  EXPECT_EQ(packet(recording, 1), packet(recording, 0)) << "the eyes do not jump, they are held";
  EXPECT_EQ(packet(read("timestamp,success,gaze_angle_x,gaze_angle_y,AU01_r\n0,1,0.244346,0,0\n"
                        "0.04,1,0,0,0\n"),
                   0),
            "{61:50;40}")
      << "a table that never has a pose is of a straight head";
}

constexpr const char* kNoseLandmarks = "x_27,x_30,x_33,y_27,y_30,y_33";
constexpr const char* kNoseOfMesh = "mesh_x_168,mesh_x_4,mesh_x_2,mesh_y_168,mesh_y_4,mesh_y_2";

/// Rows of Py-Feat with points of a nose: its tip is the lower, the more the head is down.
std::string nodding(const std::string& more_columns, const std::string& more_cells,
                    double pitch_of_down, const std::string& nose = kNoseLandmarks) {
  std::string text = "frame,FaceScore," + nose + ",Pitch,Roll,Yaw,AU01" + more_columns + "\n";
  for (int frame = 0; frame < 20; ++frame) {
    const double down = 0.01 * frame;
    text += std::to_string(frame) + ",0.9,100,100,100,100," + std::to_string(135 + 40 * down) +
            ",150," + std::to_string(down * pitch_of_down) + ",0,0,0" + more_cells + "\n";
  }
  return text;
}

TEST(PyFeat2, TheLandmarksTellWhichWayANodGoes) {
  const auto as_documented = read(nodding(",valence", ",0", -1), at_fps(25));
  EXPECT_EQ(as_documented.found.note, "pose in radians, positive pitch up as the landmarks say");
  EXPECT_EQ(packet(as_documented, 19), "{54:49;40}");
  const auto older = read(nodding(",valence", ",0", 1), at_fps(25));
  EXPECT_EQ(older.found.note, "pose in radians, positive pitch down as the landmarks say");
  EXPECT_EQ(packet(older, 19), "{54:49;40}");
  EXPECT_NE(found_lines(older.found).find("positive pitch down as the landmarks say"),
            std::string::npos);
  EXPECT_EQ(read(kPyFeat2, at_fps(25)).found.note,
            "pose in radians, positive pitch up as documented");
}

TEST(PyFeat2, AMeshAloneTellsWhichWayANodGoes) {
  const auto older = read(nodding(",valence", ",0", 1, kNoseOfMesh), at_fps(25));
  EXPECT_EQ(older.found.note, "pose in radians, positive pitch down as the landmarks say");
  EXPECT_EQ(packet(older, 19), "{54:49;40}");
  const auto as_documented = read(nodding(",valence", ",0", -1, kNoseOfMesh), at_fps(25));
  EXPECT_EQ(as_documented.found.note, "pose in radians, positive pitch up as the landmarks say");
  EXPECT_EQ(packet(as_documented, 19), "{54:49;40}");
}

TEST(PyFeat2, TheMeshComesBeforeLandmarksThatStandStill) {
  const auto both = read(nodding(",valence,x_27,x_30,x_33,y_27,y_30,y_33",
                                 ",0,100,100,100,100,135,150", 1, kNoseOfMesh),
                         at_fps(25));
  EXPECT_EQ(both.found.note, "pose in radians, positive pitch down as the landmarks say");
}

TEST(PyFeat1, TodaysPoseIsInRadiansWithGaze) {
  const auto recording = read(
      "FaceRectX,FaceScore,Pitch,Roll,Yaw,X,Y,Z,AU01,anger,gaze_pitch,gaze_yaw,gaze_angle,frame\n"
      "236,0.99,0,0.191986,0.305433,0,0,0,0.25,0.1,0.191986,-0.244346,0,0\n"
      "236,0.99,0,0,0,0,0,0,0.25,0.1,0,0,0,1\n",
      at_fps(25));
  EXPECT_EQ(recording.found.format, "Py-Feat 1");
  EXPECT_EQ(recording.found.note, "pose in radians, positive pitch up as documented");
  EXPECT_EQ(packet(recording, 0), "{1:25,52:50,56:50,61:50,63:50;40}");
}

TEST(PyFeat1, ATurnBeyondAQuarterIsInDegrees) {
  const auto recording = read(
      "FaceScore,Pitch,Roll,Yaw,X,AU01,frame\n0.9,0,0,17.5,1,0,0\n0.9,0,0,0.5,1,0,1\n", at_fps(25));
  EXPECT_EQ(packet(recording, 0), "{52:50;40}");
}

TEST(ArkitCurves, CamelCaseWithOrWithoutAColumnBefore) {
  const auto recording = read(kMediaPipe, at_fps(30));
  EXPECT_EQ(recording.found.format, "ARKit curves");
  EXPECT_EQ(packet(recording, 0), "{L12:50,26:40,L45:25,R45:75;33}");
  EXPECT_EQ(packet(recording, 1), "{26,L30:50;33}");
  EXPECT_EQ(packet(read("eyeBlinkLeft,eyeBlinkRight,jawOpen\n0,0,0.5\n1,1,0\n", at_fps(50)), 1),
            "{45;20}");
}

TEST(ArkitCurves, TimesAreSecondsOrMillisecondsByTheirSteps) {
  const auto time = [](const std::string& name, const std::string& first,
                       const std::string& second) {
    return packet(read(name + ",eyeBlinkLeft,jawOpen\n" + first + ",0,1\n" + second + ",0,1\n"), 1);
  };
  EXPECT_EQ(time("timestamp", "0", "0.04"), "{26;40}");
  EXPECT_EQ(time("timestamp", "0", "40"), "{26;40}");
  EXPECT_EQ(time("timestamp", "1700000000000", "1700000000040"), "{26;40}");
  EXPECT_EQ(time("time", "7.5", "7.54"), "{26;40}");
  EXPECT_EQ(time("timestamp_ms", "0", "4"), "{26;4}");
}

TEST(FaceReader, NumbersAndLettersBySideBehindItsPreamble) {
  const auto recording = read(kFaceReader);
  EXPECT_EQ(recording.found.format, "FaceReader");
  EXPECT_EQ(packet(recording, 0), "{1:25,L12:75,R12:50;40}");
  EXPECT_EQ(packet(recording, 1), "{1:50,43;40}");
  EXPECT_EQ(recording.found.lost, 1U) << "FIND_FAILED is no data";
  const auto broken = read_recording(
      "Video Time\tNeutral\tAction Unit 01 - Inner Brow Raiser\n1\t0\t0\n", "f.txt", {});
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().message,
            "f.txt:2:1: expected a time HH:MM:SS.fff, such as 00:01:20.040");
}

TEST(IMotions, FacetsEvidenceIsAnIntensityOnlyAboveEvenOdds) {
  const auto recording = read(kFacet);
  EXPECT_EQ(found_lines(recording.found).find("largest"), std::string::npos)
      << "evidence is no value of the scale";
  EXPECT_EQ(recording.found.format, "iMotions (FACET)");
  EXPECT_EQ(recording.found.note, "evidence read as intensity, approximate");
  EXPECT_EQ(packet(recording, 0), "{12:82,51:50,54:50,56:50;40}");
  EXPECT_EQ(packet(recording, 1), "{12;40}");
  EXPECT_EQ(recording.found.lost, 1U) << "no face";
}

TEST(IMotions, AffdexIsPercentByItsOwnNames) {
  const auto recording = read(kAffdex);
  EXPECT_EQ(recording.found.format, "iMotions (AFFDEX)");
  EXPECT_EQ(recording.found.scale, 100);
  EXPECT_EQ(packet(recording, 0), "{1:3,2:25,12:76;40}");
  EXPECT_EQ(packet(recording, 1), "{12:4,43;40}");
}

TEST(Tables, SeparatorLinesAndReturnsAloneAreUnderstood) {
  const std::string rows = "timestamp;success;AU01_r\r0,0;1;2,5\r0,04;1;5,0\r";
  for (const std::string& text : {rows, "sep=;\r" + rows, "\"sep=;\"\r" + rows}) {
    EXPECT_EQ(packet(read(text), 0), "{1:50;40}") << text;
    EXPECT_EQ(packet(read(text), 1), "{1;40}") << text;
  }
  EXPECT_EQ(content_kind("sep=;\r\n" + rows.substr(0, rows.find('\r')) + "\r\n"),
            ContentKind::Recording);
}

TEST(Labels, OfDatabasesAreNamedWithWhatIsMissing) {
  const std::string bp4d =
      "0,1,2,4,5,6,7,9,10,11,12,13,14,15,16,17,18,19,20,22,23,24,27,28\n1,0,0,0,0,0,0,0,0,0,0,0,0,"
      "0,"
      "0,0,0,0,0,0,0,0,0,9\n";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"1,0\r\n2,0\r\n3,5\r\n4,0\r\n", "label file of DISFA or BP4D"},
      {"2440,9\n2441,0\n2442,3\n", "label file of DISFA or BP4D"},
      {bp4d, "occurrence file of BP4D"},
      {"   1.2000000e+01   3.0000000e+00\n   2.5000000e+01   0.0000000e+00\n", "FACS file of CK+"}};
  for (const auto& [text, seems] : files) {
    EXPECT_EQ(content_kind(text), ContentKind::Unknown) << text;
    const auto recording = read_recording(text, "f.txt", {});
    ASSERT_FALSE(recording) << text;
    EXPECT_NE(recording.error().message.find(seems), std::string::npos)
        << recording.error().message;
    EXPECT_NE(recording.error().message.find("timestamp,AU01_r"), std::string::npos);
  }
  for (const char* text :
       {"1,6\n2,4\n3,1\nEnd_Stream", "Beg_Stream\n1,0\n2,0\n3,0\n", "1,0\n2,0\n"}) {
    EXPECT_EQ(label_file(text), std::nullopt) << text;
  }
}

TEST(UnknownTable, OfAusIsToldHowToNameThem) {
  const std::string reason = unknown_reason("time,AU1,AU2,AU12\n0,1,2,3\n");
  EXPECT_NE(reason.find("named AU01_r, AU02_r, ... beside a timestamp they are read"),
            std::string::npos)
      << reason;
}

TEST(LibreFace, MillisecondsAndPresences) {
  const auto recording = read(kLibreFace);
  EXPECT_EQ(recording.found.format, "LibreFace");
  EXPECT_EQ(recording.found.scale, 5);
  EXPECT_EQ(packet(recording, 0), "{1:50,7:50,12:10;40}");
  EXPECT_EQ(packet(recording, 1), "{12;40}");
}

TEST(LiveLinkFace, CurvesByNameOverMidnight) {
  const auto recording = read(kLiveLinkFace);
  EXPECT_EQ(recording.found.format, "Live Link Face");
  EXPECT_EQ(recording.found.note, "curves read as AUs by a table, approximate");
  // 0.1 rad right and 0.2 rad down of 28 and 22 degrees; two frames of 60 a second.
  EXPECT_EQ(packet(recording, 0), "{L12:60,R12:50,26:40,R30:30,L45:25,R45:75,62:20,64:52;33}");
  EXPECT_EQ(packet(recording, 1), "{26,L30:20,61:20,63:52;33}");
}

TEST(LiveLinkFace, WithoutEyeAnglesTheLookCurvesCount) {
  const auto recording = read(
      "Timecode,BlendShapeCount,EyeBlinkLeft,EyeLookInLeft,JawOpen,LeftEyeYaw,LeftEyePitch\n"
      "01:00:00:00.000,61,0,0.5,0,0,0\n01:00:00:01.000,61,0,0,0,0,0\n");
  EXPECT_EQ(packet(recording, 0), "{L62:50;17}");
}

TEST(LiveLinkFace, HeadTurnsLikeTheEyes) {
  const auto recording = read(
      "Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen,HeadYaw,HeadPitch,HeadRoll\n"
      "01:00:00:00.000,61,0,0,0.305433,0.191986,0\n01:00:00:01.000,61,0,0,0,0,0\n");
  EXPECT_EQ(packet(recording, 0), "{52:50,54:50;17}");
}

TEST(LiveLinkFace, PacketsWithoutAFaceAreNoData) {
  const auto recording = read(
      "Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen\n"
      "01:00:00:00.000,61,0,0.5\n01:00:00:01.000,0,0,0\n");
  EXPECT_EQ(recording.found.lost, 1U);
  EXPECT_EQ(packet(recording, 1), "{26:50;17}") << "held";
}

TEST(LiveLinkFace, WrongTimecodesAreRefused) {
  for (const char* timecode :
       {"x", "1:2:3", "1:2:3:4:5", "24:00:00:00", "00:60:00:00", "0:0:0:-1"}) {
    const auto recording = read_recording(
        std::string("Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen\n") + timecode + ",61,0,0\n",
        "f.csv", {}, {}, [] { return Result<ArkitTable>(kCurves); });
    ASSERT_FALSE(recording) << timecode;
    EXPECT_EQ(recording.error().message,
              "f.csv:2:1: expected a timecode HH:MM:SS:FF.fff, such as 16:55:51:38.453");
  }
}

TEST(ContentKind, IsFoundByTheFirstLine) {
  EXPECT_EQ(content_kind(kOpenFace2Header), ContentKind::Recording);
  for (const char* text : {kOpenFace1, kFacsvatar, kPyFeat1, kPyFeat2, kLibreFace, kFaceReader,
                           kFacet, kAffdex, kLiveLinkFace, kMediaPipe}) {
    EXPECT_EQ(content_kind(text), ContentKind::Recording) << text;
  }
  EXPECT_EQ(content_kind("time,happiness,sadness\n1,2,3\n"), ContentKind::Unknown);
  for (const char* text : {"", "Beg_Stream\n1,2\nEnd_Stream\n", "# talk, AUs, and more\nBeg_Stream",
                           "1,2,3\n", "{1,6,12}\n", "1C+4B,5,6", "hello"}) {
    EXPECT_EQ(content_kind(text), ContentKind::StreamFile) << text;
  }
}

}  // namespace
}  // namespace aucast::sources
