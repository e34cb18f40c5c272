#include "tests/support/process.h"

#include <csignal>

#include <gtest/gtest.h>

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

TEST(Process, CatchesOutputAndExitCode) {
  const Finished finished = run({"sh", "-c", "echo out; echo $WORD >&2; exit 7"}, {"WORD=err"});
  EXPECT_EQ(finished.exit_code, 7);
  EXPECT_EQ(finished.out, "out\n");
  EXPECT_EQ(finished.err, "err\n");
}

TEST(Process, ReadsLinesWhileItRuns) {
  Process process({"sh", "-c", "echo one; echo two; exec sleep 60"});
  EXPECT_EQ(process.read_line(10s), "one");
  EXPECT_EQ(process.read_line(10s), "two");
  EXPECT_FALSE(process.read_line(10ms).has_value());
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(10s), 128 + SIGTERM);
}

TEST(Process, MissingProgramIs127) {
  EXPECT_EQ(run({"no-such-program"}).exit_code, 127);
}

}  // namespace
}  // namespace aucast::test
