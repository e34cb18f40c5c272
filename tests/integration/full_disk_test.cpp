// face-player on a disk that is full: a tmpfs of some kilobytes in a mount namespace of its own.
#include <gtest/gtest.h>

#include "tests/support/process.h"
#include "tests/support/served.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

/// Runs face-player with `output`, in which DISK stands for a disk of so many kilobytes. Afterwards
/// prints the files that are there, and the pictures that are not whole as "torn NAME".
Finished run_on_small_disk(int kilobytes, const std::string& output) {
  const TempFolder folder;
  std::string script = "mount -t tmpfs -o size=" + std::to_string(kilobytes) + "k none DISK && { " +
                       program("face-player") + " play " + stream_file("six_expressions.txt") +
                       " --headless --size 320x240 --fps 20 " + output +
                       "; code=$?; cd DISK; find . -type f; "
                       "find . -name '*.png' -exec grep -aL IEND {} + | sed 's/^/torn /'; "
                       "exit $code; }";
  for (auto at = script.find("DISK"); at != std::string::npos; at = script.find("DISK")) {
    script.replace(at, 4, folder.path().string());
  }
  return run({"unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script});
}

class FullDisk : public ::testing::Test {
 protected:
  void SetUp() override {
    const Finished probe = run({"unshare", "--user", "--map-root-user", "--mount", "sh", "-c",
                                "mount -t tmpfs -o size=64k none /mnt"});
    if (probe.exit_code != 0) GTEST_SKIP() << "no mount namespaces here: " << probe.err;
  }
};

TEST_F(FullDisk, WhileRecordingFailsAndLeavesNoHalfVideo) {
  const Finished done = run_on_small_disk(8, "--record DISK/video.mp4");
  EXPECT_EQ(done.exit_code, 1) << done.err;
  EXPECT_NE(done.err.find("video.mp4"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("No space left on device"), std::string::npos) << done.err;
  EXPECT_EQ(done.out.find("video.mp4"), std::string::npos) << done.out;
}

TEST_F(FullDisk, WhileWritingPicturesFailsAndLeavesOnlyWholeOnes) {
  const Finished done = run_on_small_disk(200, "--frames DISK/out");
  EXPECT_EQ(done.exit_code, 1) << done.err;
  EXPECT_NE(done.err.find("No space left on device"), std::string::npos) << done.err;
  EXPECT_NE(done.out.find("frame_000001.png"), std::string::npos) << done.out;
  EXPECT_EQ(done.out.find("frame_000030.png"), std::string::npos) << done.out;
  EXPECT_EQ(done.out.find("torn"), std::string::npos) << done.out;
}

TEST_F(FullDisk, TheStatisticsSayHowFarItCame) {
  const Finished done = run_on_small_disk(1000, "--frames DISK/out --stats /dev/stdout");
  EXPECT_EQ(done.exit_code, 1) << done.err;
  EXPECT_NE(done.out.find("\"end_reason\": \"failed\""), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\"keyframes_played\": "), std::string::npos) << done.out;
  EXPECT_EQ(done.out.find("\"keyframes_played\": 0,"), std::string::npos) << done.out;
}

TEST_F(FullDisk, IsSaidOfTheStatisticsToo) {
  const Finished done = run_on_small_disk(64, "--stats /dev/full");
  EXPECT_EQ(done.exit_code, 1) << done.err;
  EXPECT_NE(done.err.find("/dev/full"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace aucast::test
