#include "server/streams/check_report.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

std::string report_of(const std::string& packets) {
  const test::TempFolder folder;
  const auto path = folder.write("talk.txt", "Beg_Stream\n" + packets + "End_Stream\n");
  const auto sources = load_sources({path});
  if (!sources) return sources.error().message;
  std::string text = check_report(sources->front(), 250);
  const std::size_t at = text.find(path.string());
  return at == std::string::npos ? text : text.replace(at, path.string().size(), "PATH");
}

TEST(CheckReport, SaysWhatAStreamHolds) {
  EXPECT_EQ(report_of("1:30,L12:80,R12:70;40\n6,12\n0;1000\n"),
            "talk: PATH\n"
            "  keyframes   3, 1 of them untimed\n"
            "  duration    1.290 s at 250 ms an untimed keyframe\n"
            "  classic     15 bytes, 5.0 a keyframe (3 to 6)\n"
            "  level 2     37 bytes, 12.3 a keyframe (6 to 23)\n"
            "  changes     37 bytes, 12.3 a keyframe (6 to 23)\n"
            "  bit rate    0.2 kbit/s\n"
            "  AU  keyframes  percent  name\n"
            "   0          1      100  Neutral Face\n"
            "   1          1       30  Inner Brow Raiser\n"
            "   6          1      100  Cheek Raiser\n"
            "  12          2   80-100  Lip Corner Puller\n");
}

TEST(CheckReport, NumberWithoutANameIsSaid) {
  EXPECT_NE(report_of("99\n").find("  99          1      100  (not a FACS number)\n"),
            std::string::npos);
}

/// Half a second at 200 pictures a second; the head looks down and AUs 1 and 12 tremble.
std::string report_of_table(const std::string& pitch_rad) {
  const test::TempFolder folder;
  std::string table = "frame,face_id,timestamp,success,pose_Rx,pose_Ry,pose_Rz,AU01_r,AU12_r\n";
  for (int frame = 0; frame < 100; ++frame) {
    table += std::to_string(frame) + ",0," + std::to_string(frame * 0.005) + ",1," + pitch_rad +
             ",0,0," + (frame % 2 == 0 ? "1,4" : "3,2") + "\n";
  }
  const auto sources = load_sources({folder.write("talk.csv", table)});
  if (!sources) return sources.error().message;
  return check_report(sources->front(), 250);
}

TEST(CheckReport, AFaceThatLooksAwayIsToldWithWhatMendsIt) {
  EXPECT_NE(report_of_table("0.19").find(
                "  looks away  Head Down 49 % most of the time; --neutral 2 straightens it"),
            std::string::npos)
      << report_of_table("0.19");
  EXPECT_EQ(report_of_table("0.05").find("looks away"), std::string::npos);
}

TEST(CheckReport, MoreThanAThinLineTakesIsToldWithWhatLowersIt) {
  const std::string text = report_of_table("0");
  EXPECT_NE(text.find("kbit/s; --max-bitrate 12, --rate 15 or --dead-band 5 lower it\n"),
            std::string::npos)
      << text;
}

TEST(CheckReport, TableFiveFiveIsInIt) {
  const std::string text = report_of("1,2,5,15,16,20,26\n");
  EXPECT_NE(text.find("  classic     19 bytes, 19.0 a keyframe (19 to 19)\n"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace aucast::server
