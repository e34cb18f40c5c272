#include "client/app/progress_line.h"

#include <pty.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "common/descriptor.h"

namespace aucast::app {
namespace {

/// What `act` writes to standard error if that is a terminal.
template <typename Act>
std::string on_terminal(const Act& act) {
  int ours = -1;
  int theirs = -1;
  EXPECT_EQ(::openpty(&ours, &theirs, nullptr, nullptr, nullptr), 0);
  const Descriptor reader(ours);
  const Descriptor terminal(theirs);
  const Descriptor before(::dup(STDERR_FILENO));
  ::dup2(terminal.get(), STDERR_FILENO);
  act();
  std::fflush(stderr);
  ::dup2(before.get(), STDERR_FILENO);
  std::array<char, 512> bytes{};
  const ssize_t got = ::read(reader.get(), bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0))};
}

TEST(ProgressLine, AWarningGetsALineOfItsOwnOnATerminal) {
  const std::string written = on_terminal([] {
    ProgressLine progress(true);
    progress.show([] { return "1 picture"; });
    progress.interrupt();
    std::fputs("lost\n", stderr);
    progress.interrupt();
    progress.end_with("2 pictures");
  });
  EXPECT_EQ(written, "\r1 picture\r\nlost\r\n2 pictures\r\n");
}

}  // namespace
}  // namespace aucast::app
