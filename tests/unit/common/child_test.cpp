#include "common/child.h"

#include <dlfcn.h>
#include <spawn.h>

#include <array>
#include <bitset>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/eventually.h"
#include "tests/support/temp_folder.h"

// Linked before the system's own, so that a test can have them fail.

namespace {

int attributes_error = 0;
int actions_error = 0;

template <typename Function>
Function* system_function(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int posix_spawnattr_setflags(posix_spawnattr_t* attributes, short flags) noexcept {
  static auto* const own = system_function<int(posix_spawnattr_t*, short)>(__func__);
  return attributes_error != 0 ? attributes_error : own(attributes, flags);
}

extern "C" int posix_spawn_file_actions_addopen(posix_spawn_file_actions_t* actions, int descriptor,
                                                const char* path, int flags, mode_t mode) noexcept {
  static auto* const own =
      system_function<int(posix_spawn_file_actions_t*, int, const char*, int, mode_t)>(__func__);
  return actions_error != 0 ? actions_error : own(actions, descriptor, path, flags, mode);
}

namespace aucast {
namespace {

std::unique_ptr<Child> shell(const std::string& script) {
  auto child = Child::start({"sh", "-c", script});
  EXPECT_TRUE(child.has_value());
  return std::move(child.value());
}

TEST(Child, TakesAllBytesAndTellsItsCode) {
  const test::TempFolder folder;
  const auto file = folder.path() / "out";
  const std::vector<std::uint8_t> bytes(3'000'000, 'x');
  const auto child = shell("cat > '" + file.string() + "'; echo done >&2; exit 7");
  EXPECT_TRUE(child->feed(bytes));
  EXPECT_EQ(child->wait(), 7);
  EXPECT_EQ(child->wait(), 7);
  EXPECT_EQ(child->error_tail(), "done");
  EXPECT_EQ(std::filesystem::file_size(file), bytes.size());
}

TEST(Child, IsAwaitedUntilItWritesOrEnds) {
  using namespace std::chrono_literals;
  const auto begin = [](const char* script) {
    return *Child::start({"sh", "-c", script}, Child::Flow::Read);
  };
  const auto silent = begin("echo trouble >&2; exec sleep 60");
  EXPECT_FALSE(silent->await(50ms));
  silent->stop();
  EXPECT_TRUE(silent->await(20s));
  const auto writer = begin("echo it");
  EXPECT_TRUE(writer->await(20s));
  std::vector<std::uint8_t> bytes(8);
  EXPECT_EQ(writer->read(bytes), 3U);
}

TEST(Child, FlowsBothWaysUntilItsInputEnds) {
  auto started = Child::start(
      {"sh", "-c", "while read word; do echo \"got $word\"; done; echo first >&2; echo last >&2"},
      Child::Flow::Both);
  ASSERT_TRUE(started.has_value());
  const auto child = *std::move(started);
  std::string text;
  std::vector<std::uint8_t> chunk(100);
  const auto read = [&] {
    const std::size_t got = child->read(chunk);
    text.append(chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(got));
    return got > 0;
  };
  EXPECT_TRUE(child->tell("this\n"));
  while (text != "got this\n") ASSERT_TRUE(read());
  child->end_input();
  while (read()) {
  }
  EXPECT_EQ(child->wait(), 0);
  EXPECT_EQ(child->error_tail(), "first last");
  EXPECT_EQ(child->last_line(), "last");
}

TEST(Child, SaysThatThereIsNoSuchProgram) {
  const auto child = Child::start({"aucast-no-such-program"});
  ASSERT_FALSE(child.has_value());
  EXPECT_EQ(child.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(child.error().message.find("aucast-no-such-program cannot be started"),
            std::string::npos);
}

TEST(Child, DoesNotStartOtherwiseThanItIsAsked) {
  for (int* const error : {&attributes_error, &actions_error}) {
    *error = ENOMEM;
    const auto child = Child::start({"true"});
    *error = 0;
    ASSERT_FALSE(child.has_value());
    EXPECT_EQ(child.error(),
              (Error{ErrorKind::Failed, "true cannot be started: Cannot allocate memory"}));
  }
}

TEST(Child, NoticesWithoutASignalThatNobodyReads) {
  const std::vector<std::uint8_t> bytes(8'000'000, 'x');
  const auto child = shell("exec <&-; echo gone >&2; exit 3");
  EXPECT_FALSE(child->feed(bytes));
  EXPECT_FALSE(child->feed(bytes));
  EXPECT_EQ(child->wait(), 3);
  EXPECT_EQ(child->error_tail(), "gone");
}

TEST(Child, ReadsErrorsMeanwhileAndKeepsTheLast) {
  // More than a pipe holds: without being read the child would wait for ever, and so would we.
  const std::vector<std::uint8_t> bytes(4'000'000, 'x');
  const auto child =
      shell("head -c 1000000 /dev/zero | tr '\\0' e >&2; cat > /dev/null; echo the last words >&2");
  EXPECT_TRUE(child->feed(bytes));
  EXPECT_EQ(child->wait(), 0);
  EXPECT_EQ(child->error_tail(), std::string(286, 'e') + "the last words");
}

TEST(Child, SaysItsLastWordsInOneLineThatIsSafeToPrint) {
  const auto child = shell("printf 'no \\033[2J room\\non the disk\\n\\n' >&2; exit 1");
  EXPECT_EQ(child->wait(), 1);
  EXPECT_EQ(child->error_tail(), "no \\x1b[2J room on the disk");
}

TEST(Child, SaysItsLastLineWholeAndInItsLetters) {
  const auto child = shell(
      "printf 'first\\n/home/ren\\303\\251/\\033' >&2;"
      "head -c 900 /dev/zero | tr '\\0' e >&2; echo ' fetches them' >&2; exit 1");
  EXPECT_EQ(child->wait(), 1);
  EXPECT_EQ(child->last_line(),
            "/home/ren\xc3\xa9/\\x1b" + std::string(900, 'e') + " fetches them");
}

TEST(Child, TellsTheSignalThatKilledIt) {
  const auto child = shell("kill -9 $$");
  EXPECT_EQ(child->wait(), 128 + SIGKILL);
  EXPECT_FALSE(child->killed()) << "from here";
}

TEST(Child, BeginsWithNoSignalIgnored) {
  const std::array numbers{SIGQUIT, SIGXFSZ, SIGUSR1, SIGPIPE};
  for (const int number : numbers) std::signal(number, SIG_IGN);
  const auto child = *Child::start({"sed", "-n", "s/^SigIgn:[[:blank:]]*//p", "/proc/self/status"},
                                   Child::Flow::Read);
  for (const int number : numbers) std::signal(number, SIG_DFL);
  std::array<std::uint8_t, 32> bytes{};
  const std::size_t size = child->read(bytes);
  const auto ignored = std::stoull(std::string(bytes.begin(), bytes.begin() + size), nullptr, 16);
  for (const int number : numbers)
    EXPECT_FALSE(std::bitset<64>(ignored).test(static_cast<std::size_t>(number - 1))) << number;
}

TEST(Child, IsWaitedForWhereWeWereStartedWithTheEndsOfChildrenIgnored) {
  auto* const before = std::signal(SIGCHLD, SIG_IGN);
  const auto child = shell("exit 7");
  const bool ended = child->ends_within(std::chrono::seconds(20));
  std::signal(SIGCHLD, before);
  ASSERT_TRUE(ended);
  EXPECT_EQ(child->wait(), 7);
}

TEST(Child, LeavesTheHandlerOfTheEndsOfChildrenThatIsThere) {
  const auto handler = [](int) {};
  auto* const before = std::signal(SIGCHLD, handler);
  EXPECT_EQ(shell("exit 7")->wait(), 7);
  EXPECT_EQ(std::signal(SIGCHLD, before), +handler);
}

/// Whether so much time has passed that somebody must have waited for the sleepers of these tests.
class Waited {
 public:
  explicit operator bool() const {
    return std::chrono::steady_clock::now() - begin_ > std::chrono::seconds(30);
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

TEST(Child, IsKilledWhenItIsGivenUp) {
  const Waited waited;
  int asked = 0;
  const auto begin = [&asked](const char* script, Child::Flow flow) {
    asked = 0;
    return *Child::start({"sh", "-c", script}, flow, [&asked] { return ++asked > 2; });
  };
  std::vector<std::uint8_t> bytes(8'000'000, 'x');
  const auto fed = begin("sleep 60", Child::Flow::Fed);
  EXPECT_FALSE(fed->feed(bytes));
  EXPECT_EQ(fed->wait(), 128 + SIGKILL);
  EXPECT_TRUE(fed->killed());
  const auto read = begin("sleep 60", Child::Flow::Read);
  EXPECT_EQ(read->read(bytes), 0U);
  EXPECT_EQ(read->wait(), 128 + SIGKILL);
  EXPECT_EQ(begin("sleep 60", Child::Flow::Fed)->wait(), 128 + SIGKILL);
  EXPECT_EQ(begin("exec 2>&-; sleep 60", Child::Flow::Fed)->wait(), 128 + SIGKILL);
  EXPECT_FALSE(waited);
}

TEST(Child, IsKilledWhenItTakesTooLongToEnd) {
  const Waited waited;
  const auto child = shell("echo stuck >&2; sleep 60");
  EXPECT_EQ(child->wait(Milliseconds(300)), 128 + SIGKILL);
  EXPECT_TRUE(child->killed());
  EXPECT_EQ(child->error_tail(), "stuck");
  EXPECT_FALSE(waited);
}

TEST(Child, WaitsForNobodyWhoKeepsItsPipesOpenAfterItsEnd) {
  const Waited waited;
  const auto child = shell("echo first >&2; sleep 60 & exit 4");
  EXPECT_EQ(child->wait(), 4);
  EXPECT_EQ(child->error_tail(), "first");
  const auto read = *Child::start({"sh", "-c", "echo it; sleep 60 &"}, Child::Flow::Read);
  std::vector<std::uint8_t> bytes(8);
  EXPECT_EQ(read->read(bytes), 3U);
  EXPECT_EQ(read->read(bytes), 0U);
  EXPECT_EQ(read->wait(), 0);
  // Not even for one that has left its group.
  EXPECT_EQ(shell("setsid sleep 40 & exit 4")->wait(), 4);
  EXPECT_FALSE(waited);
}

TEST(Child, TakesWhatItHasStartedWithIt) {
  const auto pid_of_sleeper = [](Child& child) {
    std::array<std::uint8_t, 32> bytes{};
    const std::size_t size = child.read(bytes);
    return std::stoi(std::string(bytes.begin(), bytes.begin() + size));
  };
  // An orphan is a zombie for a while, until somebody reaps it.
  const auto gone = [](int pid) {
    std::ifstream status("/proc/" + std::to_string(pid) + "/stat");
    std::string text;
    std::getline(status, text);
    return text.empty() || text.find(") Z ") != std::string::npos;
  };
  for (const bool stopped : {true, false}) {
    auto child = *Child::start({"sh", "-c", "sleep 1000 & echo $!; wait"}, Child::Flow::Read);
    const int pid = pid_of_sleeper(*child);
    EXPECT_FALSE(gone(pid));
    if (stopped) {
      child->stop();
      EXPECT_EQ(child->wait(), 128 + SIGKILL);
      child->stop();  // its number is nobody's any more
    } else {
      child.reset();
    }
    EXPECT_TRUE(test::eventually([&] { return gone(pid); }));
  }
}

TEST(Child, IsOutOfReachOfCtrlC) {
  // A terminal's interrupt goes to the group of processes of the program that runs in it.
  const auto child = shell("test \"$(ps -o pgid= -p $$ | tr -d ' ')\" = $$");
  EXPECT_EQ(child->wait(), 0);
}

TEST(Child, IsKilledAndReapedWithItsOwner) {
  auto child = *Child::start({"sh", "-c", "echo $$; read line; sleep 1000"}, Child::Flow::Both);
  std::array<std::uint8_t, 32> bytes{};
  const std::size_t size = child->read(bytes);
  const pid_t pid = std::stoi(std::string(bytes.begin(), bytes.begin() + size));
  ASSERT_EQ(::kill(pid, 0), 0);
  child.reset();
  EXPECT_EQ(::kill(pid, 0), -1);
}

TEST(Child, IsReadToItsEnd) {
  auto child = Child::start({"sh", "-c", "printf hello; echo why >&2; printf ' you'; exit 3"},
                            Child::Flow::Read);
  ASSERT_TRUE(child.has_value());
  std::string text;
  std::vector<std::uint8_t> chunk(4);
  while (const std::size_t got = (*child)->read(chunk)) {
    text.append(chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(got));
  }
  EXPECT_EQ(text, "hello you");
  EXPECT_EQ((*child)->wait(), 3);
  EXPECT_EQ((*child)->error_tail(), "why");
}

TEST(Child, IsStoppedWhileItIsRead) {
  auto child = Child::start({"sh", "-c", "while :; do echo on; done"}, Child::Flow::Read);
  ASSERT_TRUE(child.has_value());
  std::vector<std::uint8_t> chunk(64);
  ASSERT_GT((*child)->read(chunk), 0U);
  (*child)->stop();
  while ((*child)->read(chunk) > 0) {
  }
  EXPECT_EQ((*child)->wait(), 128 + 9);
  EXPECT_TRUE((*child)->killed());
}

}  // namespace
}  // namespace aucast
