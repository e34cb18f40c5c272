// A recogniser's signals made ready to be shown, through the real transmitter.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

constexpr const char* kColumns =
    "face_id,timestamp,success,pose_Tz,pose_Rx,pose_Ry,pose_Rz,AU04_r,AU12_r,AU45_r\n";

/// One row at 25 pictures a second: a face whose brows are always half a point down and whose head
/// is turned a little, 420 mm away.
std::string row(int frame, const std::string& smile, const std::string& tz = "420") {
  const int ms = frame * 40;
  return "0," + std::to_string(ms / 1000) + "." + std::to_string(1000 + ms % 1000).substr(1) +
         ",1," + tz + ",0,0.1,0,0.5," + smile + ",0\n";
}

/// A second of rest, then a smile.
std::string recording() {
  std::string text = kColumns;
  for (int frame = 0; frame < 25; ++frame) text += row(frame, "0.25");
  for (int frame = 25; frame < 50; ++frame) text += row(frame, "2.75", "413");
  return text;
}

std::string converted(const std::vector<std::string>& options, const std::string& file) {
  std::vector<std::string> command{program("au-transmitter"), "convert"};
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), {file, "-"});
  const Finished done = run(command);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  return done.out;
}

TEST(ServerSignal, ANeutralFaceIsMeasuredSavedAndUsedNextTime) {
  const TempFolder folder;
  const auto csv = folder.write("face.csv", recording()).string();
  const std::string profile = (folder.path() / "me.toml").string();
  EXPECT_TRUE(has(converted({}, csv), "Beg_Stream\n4:10,12:5,52:16;40\n"));
  const std::string measured = converted({"--neutral", "1", "--save-profile", profile}, csv);
  EXPECT_TRUE(has(measured, "Beg_Stream\n0;40\n")) << measured;
  EXPECT_TRUE(has(measured, "\n12:50;40\nEnd_Stream")) << measured;
  const std::string saved = folder.read("me.toml");
  EXPECT_TRUE(has(saved, "[neutral]\n4 = 10\n12 = 5\n52 = 16.37\n")) << saved;
  // Of a recording that begins in the middle of the smile nothing could be measured.
  const auto smiling =
      folder.write("smiling.csv", kColumns + row(0, "2.75") + row(1, "2.75")).string();
  EXPECT_EQ(converted({"--profile", profile}, smiling),
            "Beg_Stream\n12:50;40\n12:50;40\nEnd_Stream\n");
}

TEST(ServerSignal, TheDistanceIsShownAndKeptWhenItIsAskedFor) {
  const TempFolder folder;
  const auto csv = folder.write("face.csv", recording()).string();
  const std::string profile = (folder.path() / "me.toml").string();
  const std::string nearer =
      converted({"--distance", "--neutral", "1", "--save-profile", profile}, csv);
  EXPECT_TRUE(has(nearer, "Beg_Stream\n0;40\n")) << nearer;
  EXPECT_TRUE(has(nearer, "\n12:50,57:50;40\nEnd_Stream")) << "7 of 14 mm: " << nearer;
  EXPECT_TRUE(has(folder.read("me.toml"), "\ndistance-mm = 420\n"));
  const auto back = folder.write("back.csv", kColumns + row(0, "0.25", "434")).string();
  EXPECT_EQ(converted({"--distance", "--profile", profile}, back), "Beg_Stream\n58\nEnd_Stream\n");
}

TEST(ServerSignal, CheckSaysWhatWasMeasuredAndSavesItToo) {
  const TempFolder folder;
  const auto csv = folder.write("face.csv", recording()).string();
  const std::string profile = (folder.path() / "me.toml").string();
  const Finished check = run({program("au-transmitter"), "--check", "--neutral", "0.5",
                              "--save-profile", profile, "--gain", "45=1.6", csv});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_TRUE(
      has(check.out, "  neutral     measured in 13 rows of 0.5 s: 4 10 %, 12 5 %, 52 16 %\n"))
      << check.out;
  EXPECT_TRUE(has(folder.read("me.toml"), "[gain]\nall = 1\n45 = 1.6\n"));
}

TEST(ServerSignal, AFilterIsSmoothAndLate) {
  const TempFolder folder;
  const auto csv = folder.write("face.csv", recording()).string();
  EXPECT_TRUE(has(converted({}, csv), "12:5,52:16;40\n4:10,12:55,52:16;40\n"));
  const std::string smooth = converted({"--filter", "1,0"}, csv);
  // 2 pi 0.04 / (1 + 2 pi 0.04) = 0.2008 of the way from 5 to 55 after one row.
  EXPECT_TRUE(has(smooth, "12:5,52:16;40\n4:10,12:15,52:16;40\n")) << smooth;
}

TEST(ServerSignal, MistakesEndWithTheirExitCodes) {
  const TempFolder folder;
  const auto csv = folder.write("face.csv", recording()).string();
  const auto other = folder.write("other.csv", recording()).string();
  const auto bad = folder.write("bad.toml", "[gain]\n12 = 99\n").string();
  const std::string saved = (folder.path() / "p.toml").string();
  const auto check = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {program("au-transmitter"), "--check"});
    return run(arguments);
  };
  const Finished wrong = check({"--profile", bad, csv});
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_EQ(wrong.err, bad + ":2:6: 12 is not from 0 to 10\n");
  EXPECT_EQ(check({"--profile", bad + ".none", csv}).exit_code, 4);
  EXPECT_EQ(check({"--gain", "12=99", csv}).exit_code, 2);
  EXPECT_EQ(check({"--save-profile", (folder.path() / "no" / "p").string(), csv}).exit_code, 1);
  const Finished two = check({"--neutral", "1", "--save-profile", saved, csv, other});
  EXPECT_EQ(two.exit_code, 2);
  EXPECT_TRUE(has(two.err, "takes one source of a recogniser, and there are 2")) << two.err;
  EXPECT_FALSE(std::filesystem::exists(saved));
}

TEST(ServerSignal, ALiveFaceThatIsNotNeutralWhileItIsMeasuredIsWarnedOf) {
  const TempFolder folder;
  const auto path = folder.write("webcam.csv", kColumns);
  RunningTransmitter server(
      {"--follow", "--source-timeout", "0", "--neutral", "0.2", path.string()});
  for (int frame = 0; frame < 6; ++frame) {
    std::ofstream(path, std::ios::app) << row(frame, "2.5") << std::flush;
  }
  EXPECT_TRUE(
      logs(server,
           "webcam.csv: AU12 50 %: no neutral face was subtracted; start again with a neutral "
           "face, or leave out --neutral"))
      << server.log();
  EXPECT_EQ(server.terminate(), 0);
}

/// A followed file, so that rows come when the test writes them.
TEST(ServerSignal, ALiveFaceIsMeasuredAndItsProfileChangesOnSighup) {
  const TempFolder folder;
  const auto path = folder.write("webcam.csv", kColumns);
  const auto profile = folder.write("me.toml", "[gain]\n12 = 1\n");
  const auto saved = folder.path() / "saved.toml";
  const auto append = [&path](const std::string& text) {
    std::ofstream(path, std::ios::app) << text << std::flush;
  };
  RunningTransmitter server({"--follow", "--source-timeout", "0", "--neutral", "0.2", "--profile",
                             profile.string(), "--save-profile", saved.string(), path.string()});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=0}", reply);
  append(row(0, "0.25"));
  EXPECT_EQ(client.receive_until("}"), "{0;40}") << "neutral from the first row on";
  for (int frame = 1; frame < 5; ++frame) append(row(frame, "0.25"));
  append(row(5, "1.25"));
  EXPECT_TRUE(has(client.receive_until("{12:20;40}"), "{12:20;40}"));
  ASSERT_TRUE(logs(server, "the profile was written to")) << server.log();
  EXPECT_TRUE(has(server.log(), "webcam.csv: neutral face measured in 5 rows of 0.2 s: 4 10 %"))
      << server.log();
  EXPECT_FALSE(has(server.log(), "no neutral face")) << server.log();
  EXPECT_TRUE(has(folder.read("saved.toml"), "\n4 = 10\n12 = 5\n52 = 16.37\n"));
  std::ofstream(profile) << "[gain]\n12 = 2\n" << std::flush;
  server.process().signal(SIGHUP);
  ASSERT_TRUE(logs(server, "the profile was read again")) << server.log();
  append(row(6, "1.75"));
  EXPECT_TRUE(has(client.receive_until("{12:60;40}"), "{12:60;40}"));
  std::ofstream(profile) << "[gain]\n12 = 99\n" << std::flush;
  server.process().signal(SIGHUP);
  ASSERT_TRUE(logs(server, "nothing was taken over")) << server.log();
  EXPECT_EQ(server.terminate(), 0);
}

}  // namespace
}  // namespace aucast::test
