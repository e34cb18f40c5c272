#include "client/app/progress_line.h"

#include <pty.h>
#include <unistd.h>

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
  {
    const Descriptor terminal(theirs);
    const Descriptor before(::dup(STDERR_FILENO));
    ::dup2(terminal.get(), STDERR_FILENO);
    act();
    std::fflush(stderr);
    ::dup2(before.get(), STDERR_FILENO);
  }
  // A terminal hands on what was written piece by piece, and fails once nobody can write any more.
  std::string written;
  std::array<char, 512> bytes{};
  for (ssize_t got = 0; (got = ::read(reader.get(), bytes.data(), bytes.size())) > 0;) {
    written.append(bytes.data(), static_cast<std::size_t>(got));
  }
  return written;
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
