// Real pipes and files, read by themselves.
#include "server/live/live_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <asio/executor_work_guard.hpp>

#include "server/live/pipe_reader.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

class LiveInputTest : public ::testing::Test {
 protected:
  LiveInput& make(const std::filesystem::path& path, bool follow, LiveInput::Opener open = {}) {
    return input_.emplace(
        io_, path, follow,
        LiveInput::Events{[this](std::string_view bytes) { came_ += bytes; },
                          [this] { ++times_caught_up_; }, [this] { ++times_ended_; },
                          [this](const std::string& why) {
                            anew_.push_back(why);
                            came_.clear();
                          }},
        std::move(open));
  }
  std::filesystem::path fifo() {
    const auto path = folder_.path() / "fifo";
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    return path;
  }
  /// Runs until exactly these bytes have come, since the input last began anew.
  [[nodiscard]] bool comes(std::string_view bytes) {
    return test::run_until(io_, [&] { return came_ == bytes; });
  }
  /// Until a growing file was read to its end once more.
  [[nodiscard]] bool catches_up() {
    const int before = times_caught_up_;
    return test::run_until(io_, [&] { return times_caught_up_ > before; });
  }

  const test::QuietLog quiet_;
  test::TempFolder folder_;
  asio::io_context io_;
  /// While nothing is read the loop would have nothing to do, and stop.
  const asio::executor_work_guard<asio::io_context::executor_type> work_ =
      asio::make_work_guard(io_);
  std::string came_;
  std::vector<std::string> anew_;
  int times_caught_up_ = 0;
  int times_ended_ = 0;
  std::optional<LiveInput> input_;
};

class Writer {
 public:
  explicit Writer(const std::filesystem::path& fifo)
      : descriptor_(::open(fifo.c_str(), O_WRONLY | O_NONBLOCK)) {
    EXPECT_GE(descriptor_, 0);
  }
  ~Writer() { ::close(descriptor_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  void say(std::string_view bytes) const {
    EXPECT_EQ(::write(descriptor_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }

 private:
  int descriptor_;
};

TEST_F(LiveInputTest, AFifoWaitsForItsNextWriter) {
  const auto path = fifo();
  LiveInput& input = make(path, false);
  ASSERT_TRUE(input.start());
  EXPECT_FALSE(input.has_past());
  for (const int number : {1, 2, 3}) {
    Writer(path).say("x");
    EXPECT_TRUE(test::run_until(io_, [&] { return times_ended_ == number; }));
    EXPECT_FALSE(input.ended());
  }
  EXPECT_EQ(came_, "xxx");
}

TEST_F(LiveInputTest, AFileThatGrowsAsItIsLookedAtIsReadOnce) {
  const auto path = folder_.write("growing", "a");
  LiveInput& input = make(path, true);
  ASSERT_TRUE(input.start());
  ASSERT_TRUE(catches_up());
  const int before = times_caught_up_;
  std::ofstream(path, std::ios::app) << "b" << std::flush;
  // The report of the change and the next look are due at once.
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  io_.poll();
  EXPECT_EQ(came_, "ab");
  EXPECT_EQ(times_caught_up_, before + 1);
}

/// Our exit code is 0 if no terminal has become ours.
void open_terminal_as_leader(asio::io_context& io, const std::string& path) {
  ::setsid();
  LiveInput input(io, path, false, {[](std::string_view) {}, [] {}, [] {}, [](const auto&) {}});
  const bool started = input.start().has_value();
  std::_Exit(started && ::open("/dev/tty", O_RDONLY | O_NOCTTY) < 0 ? 0 : 1);
}

TEST_F(LiveInputTest, ATerminalThatIsReadDoesNotBecomeOurs) {
  const Descriptor terminal(::posix_openpt(O_RDWR | O_NOCTTY));
  if (!terminal.open()) GTEST_SKIP() << "no terminal can be made here";
  ASSERT_EQ(::grantpt(terminal.get()), 0);
  ASSERT_EQ(::unlockpt(terminal.get()), 0);
  const std::string path = ::ptsname(terminal.get());
  EXPECT_EXIT(open_terminal_as_leader(io_, path), ::testing::ExitedWithCode(0), "");
}

TEST_F(LiveInputTest, AFifoThatIsGoneHasEndedWhenItsWriterHas) {
  const auto path = fifo();
  LiveInput& input = make(path, false);
  ASSERT_TRUE(input.start());
  {
    const Writer writer(path);
    std::filesystem::remove(path);
    writer.say("last");
  }
  EXPECT_TRUE(test::run_until(io_, [&] { return input.ended(); }));
  EXPECT_EQ(came_, "last");
  EXPECT_TRUE(input.failure());
  EXPECT_EQ(times_ended_, 1);
}

TEST_F(LiveInputTest, WhatWasOpenedForItEndsOnce) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  LiveInput& input =
      make("camera", true, [&ends]() -> Result<Descriptor> { return Descriptor(ends[0]); });
  ASSERT_TRUE(input.start());
  ASSERT_EQ(::write(ends[1], "row", 3), 3);
  ::close(ends[1]);
  EXPECT_TRUE(test::run_until(io_, [&] { return input.ended(); }));
  EXPECT_EQ(came_, "row");
  EXPECT_EQ(times_ended_, 1);
  EXPECT_FALSE(input.failure());
}

TEST_F(LiveInputTest, WhileItIsHeldNothingIsRead) {
  const auto path = fifo();
  LiveInput& input = make(path, false);
  input.set_reading(false);
  ASSERT_TRUE(input.start());
  const Writer writer(path);
  writer.say("a");
  io_.poll();
  EXPECT_EQ(came_, "");
  input.set_reading(true);
  EXPECT_TRUE(comes("a"));
}

TEST_F(LiveInputTest, WhatStoppedReadsNothingMore) {
  const auto path = fifo();
  LiveInput& input = make(path, false);
  ASSERT_TRUE(input.start());
  Writer(path).say("a");
  input.stop();
  io_.poll();
  EXPECT_EQ(came_, "");
  EXPECT_EQ(times_ended_, 0);
}

TEST_F(LiveInputTest, AFileThatIsNotFollowedEnds) {
  LiveInput& input = make(folder_.write("a.txt", "all"), false);
  ASSERT_TRUE(input.start());
  EXPECT_TRUE(input.has_past());
  EXPECT_TRUE(test::run_until(io_, [&] { return input.ended(); }));
  EXPECT_EQ(came_, "all");
  EXPECT_EQ(times_ended_, 1);
  EXPECT_EQ(times_caught_up_, 0);
}

TEST_F(LiveInputTest, AFollowedFileIsReadOnAsItGrows) {
  const auto path = folder_.write("a.txt", "one ");
  LiveInput& input = make(path, true);
  ASSERT_TRUE(input.start());
  EXPECT_TRUE(comes("one "));
  EXPECT_TRUE(catches_up());
  std::ofstream(path, std::ios::app) << "two";
  EXPECT_TRUE(comes("one two"));
  EXPECT_TRUE(anew_.empty());
  EXPECT_FALSE(input.ended());
}

TEST_F(LiveInputTest, AFollowedFileThatDidNotJustGrowIsReadAnew) {
  const auto path = folder_.write("a.txt", "first");
  ASSERT_TRUE(make(path, true).start());
  EXPECT_TRUE(comes("first"));
  folder_.write("a.txt", "2nd");
  EXPECT_TRUE(comes("2nd"));
  folder_.write("a.txt", "3rd");
  EXPECT_TRUE(comes("3rd"));
  std::filesystem::rename(folder_.write("b.txt", "3rd and on"), path);
  EXPECT_TRUE(comes("3rd and on"));
  EXPECT_EQ(anew_,
            (std::vector<std::string>{"it got shorter", "it was rewritten", "it was replaced"}));
  std::ofstream(path, std::ios::app) << ", grown";
  EXPECT_TRUE(comes("3rd and on, grown")) << "the new one is followed";
}

TEST_F(LiveInputTest, AFollowedFileWhoseReplacementCannotBeOpenedIsAnErrorUntilOneCan) {
  const auto path = folder_.write("a.txt", "one");
  LiveInput& input = make(path, true);
  ASSERT_TRUE(input.start());
  EXPECT_TRUE(comes("one"));
  std::filesystem::remove(path);
  EXPECT_TRUE(catches_up());
  EXPECT_FALSE(input.failure()) << "the next one may come";
  ASSERT_EQ(::mknod(path.c_str(), S_IFSOCK | 0600, 0), 0);
  EXPECT_TRUE(test::run_until(io_, [&] { return input.failure().has_value(); }));
  std::filesystem::rename(folder_.write("b.txt", "two"), path);
  EXPECT_TRUE(comes("two"));
  EXPECT_FALSE(input.failure());
}

/// Opens the file as a shell does that has read this much of it.
LiveInput::Opener opened_at(const std::filesystem::path& path, int place) {
  return [path, place]() -> Result<Descriptor> {
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    EXPECT_EQ(::lseek(file.get(), place, SEEK_SET), place);
    return file;
  };
}

TEST_F(LiveInputTest, AFollowedStdinIsReadFromItsPlaceOnAndAnew) {
  const auto path = folder_.write("a.txt", "past one");
  ASSERT_TRUE(make("-", true, opened_at(path, 5)).start());
  EXPECT_TRUE(comes("one"));
  std::ofstream(path, std::ios::app) << " two";
  EXPECT_TRUE(comes("one two"));
  EXPECT_TRUE(anew_.empty());
  folder_.write("a.txt", "2nd");
  EXPECT_TRUE(comes("2nd"));
  folder_.write("a.txt", "3rd");
  EXPECT_TRUE(comes("3rd"));
  EXPECT_EQ(anew_, (std::vector<std::string>{"it got shorter", "it was rewritten"}));
}

TEST_F(LiveInputTest, WhatStdinHadBeforeItsPlaceIsComparedToo) {
  const auto path = folder_.write("a.txt", "past");
  ASSERT_TRUE(make("-", true, opened_at(path, 4)).start());
  EXPECT_TRUE(catches_up());
  folder_.write("a.txt", "another");
  EXPECT_TRUE(comes("another"));
}

/// How many files inotify watches for this process.
std::size_t watched_files() {
  std::size_t count = 0;
  for (const auto& descriptor : std::filesystem::directory_iterator("/proc/self/fdinfo")) {
    std::ifstream info(descriptor.path());
    for (std::string line; std::getline(info, line);) count += line.starts_with("inotify wd:");
  }
  return count;
}

TEST_F(LiveInputTest, OfFilesThatWereReplacedOnlyTheLastIsWatched) {
  const auto path = folder_.write("a.txt", "0");
  ASSERT_TRUE(make(path, true).start());
  EXPECT_TRUE(comes("0"));
  for (const char* const next : {"1", "2", "3"}) {
    std::filesystem::rename(path, folder_.path() / (std::string("old") + next));
    std::filesystem::rename(folder_.write("b.txt", next), path);
    EXPECT_TRUE(comes(next));
  }
  EXPECT_EQ(watched_files(), 1U);
}

/// The event loop can wait for no plain file.
TEST_F(LiveInputTest, APipeThatCannotBeWaitedForHasEndedByAnError) {
  std::vector<std::string> heard;
  const InputReader::Events events{[&](std::string_view) { heard.emplace_back("bytes"); },
                                   [&](const Error& error) { heard.push_back(error.message); },
                                   [&] { heard.emplace_back("end"); }, [] {},
                                   [](const std::string&) {}};
  const auto path = folder_.write("a.txt", "a");
  PipeReader reader({io_, ::open(path.c_str(), O_RDONLY | O_CLOEXEC)}, "pipe", events);
  reader.start();
  EXPECT_TRUE(test::run_until(io_, [&] { return !heard.empty(); }));
  EXPECT_EQ(heard,
            (std::vector<std::string>{"pipe: cannot be read: Operation not supported", "end"}));
}

TEST_F(LiveInputTest, AFollowedFileMayBeHeldWhileItGrows) {
  const auto path = folder_.write("a.txt", "one ");
  LiveInput& input = make(path, true);
  ASSERT_TRUE(input.start());
  EXPECT_TRUE(comes("one "));
  EXPECT_TRUE(catches_up());
  input.set_reading(false);
  std::ofstream(path, std::ios::app) << "two";
  io_.run_for(std::chrono::milliseconds(1));
  input.set_reading(true);
  EXPECT_TRUE(comes("one two"));
}

TEST_F(LiveInputTest, WhatIsGoneWithHandlersOnTheirWayHearsNothing) {
  ASSERT_TRUE(make(folder_.write("a.txt", "one"), true).start());
  input_.reset();
  io_.poll();
  EXPECT_EQ(came_, "");
}

}  // namespace
}  // namespace aucast::server
