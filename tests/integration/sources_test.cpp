// A recogniser's recording from the file to the player, through both programs.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/integration/player_run.h"
#include "tests/support/served.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

/// Two seconds of OpenFace 2 at 25 pictures a second: a smile that comes and goes.
std::string openface_recording() {
  std::string text = "frame,face_id,timestamp,confidence,success,pose_Rx,pose_Ry,pose_Rz,AU12_r\n";
  for (int frame = 0; frame < 50; ++frame) {
    const int ms = frame * 40;
    text += std::to_string(frame + 1) + ",0," + std::to_string(ms / 1000) + "." +
            std::to_string(1000 + ms % 1000).substr(1) + ",0.98,1,0,0,0," +
            std::to_string(5 * std::sin(frame * 0.06)) + "\n";
  }
  return text;
}

TEST(Sources, ARecordingPlaysForAsLongAsItTook) {
  const TempFolder folder;
  Served server({folder.write("webcam.csv", openface_recording()).string()});
  ASSERT_FALSE(server.address().empty()) << server.process().err();
  const PlayerRun run = run_player({"--headless", server.address(), "--fast"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  ASSERT_FALSE(run.stats.is_null());
  EXPECT_EQ(run.stats["packets_received"], 50);
  EXPECT_NEAR(run.stats["media_seconds"].get<double>(), 2.0, 1e-6);
  EXPECT_NE(server.process().err().find("webcam.csv: OpenFace 2, AU scale 0-5, largest "),
            std::string::npos)
      << server.process().err();
}

TEST(Sources, AConvertedRecordingIsServedByteForByteTheSame) {
  const TempFolder folder;
  const auto csv = folder.write("webcam.csv", openface_recording()).string();
  const std::string converted = (folder.path() / "webcam.txt").string();
  const Finished convert = run({program("au-transmitter"), "convert", csv, converted});
  EXPECT_EQ(convert.exit_code, 0) << convert.err;
  EXPECT_NE(convert.err.find("50 keyframes, 2000 ms"), std::string::npos) << convert.err;
  const Finished direct = run({program("au-transmitter"), "convert", csv, "-"});
  const Finished again = run({program("au-transmitter"), "convert", converted, "-"});
  EXPECT_EQ(direct.out, folder.read("webcam.txt"));
  EXPECT_EQ(again.out, direct.out);
}

TEST(Sources, CheckSaysWhatWasFound) {
  const TempFolder folder;
  const auto csv = folder.write("webcam.csv", openface_recording()).string();
  const Finished check = run({program("au-transmitter"), "--check", csv});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("  format      OpenFace 2\n  scale       0-5, largest 5.00\n"
                           "  people      1: face 0 in 50 rows (taken)\n"),
            std::string::npos)
      << check.out;
  EXPECT_NE(check.out.find("duration    2.000 s"), std::string::npos) << check.out;
}

TEST(Sources, MistakesEndWithTheirExitCodes) {
  const TempFolder folder;
  const auto bad =
      folder.write("bad.csv", "timestamp,success,AU12_r\n0,1,high\n0.1,1,2\n").string();
  const Finished refused = run({program("au-transmitter"), "--check", bad});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_EQ(refused.err, bad + ":2:5: 'high' in AU12_r is not a number\n");
  const auto untimed = folder.write("pyfeat.csv", "frame,FaceScore,AU12\n0,1,1\n1,1,1\n").string();
  const Finished needs = run({program("au-transmitter"), "convert", untimed, "-"});
  EXPECT_EQ(needs.exit_code, 2);
  EXPECT_NE(needs.err.find("--fps 30"), std::string::npos) << needs.err;
  EXPECT_EQ(run({program("au-transmitter"), "convert", "--help"}).exit_code, 0);
}

}  // namespace
}  // namespace aucast::test
