// Bytes of real pipes and files, and a clock that stands still.
#include "server/live/live_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

class LiveSourceTest : public ::testing::Test {
 protected:
  LiveSource& open(const std::filesystem::path& path, bool follow) {
    LiveSourceOptions options;
    options.streams.each.path = path;
    options.streams.follow = follow;
    source_.emplace(io_, std::move(options), LiveStreams::Events{[] {}, [] {}},
                    [this] { return clock_.now(); });
    return *source_;
  }
  /// What everybody is sent now.
  [[nodiscard]] std::string newest() const {
    const protocol::LiveMoment* moment = source_->streams().served().front().live()->newest();
    return moment == nullptr ? "" : moment->full;
  }

  const test::QuietLog quiet_;
  test::TempFolder folder_;
  test::ManualClock clock_;
  asio::io_context io_;
  std::optional<LiveSource> source_;
};

TEST_F(LiveSourceTest, WhatComesThroughAPipeIsNewAlsoWhenFilesAreFollowed) {
  for (const bool follow : {false, true}) {
    const auto path = folder_.path() / (follow ? "followed" : "pipe");
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    ASSERT_TRUE(open(path, follow).start());
    const int writer = ::open(path.c_str(), O_WRONLY | O_NONBLOCK);
    ASSERT_GE(writer, 0);
    constexpr std::string_view kLines = "12:50;100\n";
    ASSERT_EQ(::write(writer, kLines.data(), kLines.size()), static_cast<ssize_t>(kLines.size()));
    EXPECT_TRUE(test::run_until(io_, [this] { return !newest().empty(); }));
    EXPECT_EQ(newest(), "{12:50;100}") << follow;
    ::close(writer);
    source_.reset();
  }
}

TEST_F(LiveSourceTest, OfAFollowedFileTheLastLineIsSent) {
  ASSERT_TRUE(open(folder_.write("growing.txt", "12:10;100\n12:20;100\n"), true).start());
  EXPECT_TRUE(test::run_until(io_, [this] { return !newest().empty(); }));
  EXPECT_EQ(newest(), "{12:20;100}");
}

/// Opens like a file, and every attempt to read it fails.
constexpr const char* kUnreadable = "/proc/self/mem";

TEST_F(LiveSourceTest, WhatCannotBeReadHasEndedAndIsAnError) {
  LiveSource& source = open(kUnreadable, false);
  ASSERT_TRUE(source.start());
  EXPECT_TRUE(test::run_until(io_, [&source] { return source.streams().nothing_came(); }));
  const auto finished = source.finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().kind, ErrorKind::Unreadable);
  EXPECT_TRUE(finished.error().message.starts_with("/proc/self/mem: cannot be read: "));
}

TEST_F(LiveSourceTest, AFollowedFileThatCannotBeReadIsTriedAgain) {
  const auto path = folder_.path() / "growing.txt";
  std::filesystem::create_symlink(kUnreadable, path);
  LiveSource& source = open(path, true);
  ASSERT_TRUE(source.start());
  EXPECT_TRUE(test::run_until(io_, [&source] { return !source.finish(); }));
  std::filesystem::remove(path);
  folder_.write("growing.txt", "12:10;100\n");
  EXPECT_TRUE(test::run_until(io_, [this] { return !newest().empty(); }));
  EXPECT_EQ(newest(), "{12:10;100}");
  EXPECT_TRUE(source.finish());
}

TEST_F(LiveSourceTest, WhatIsNotThereIsAnError) {
  EXPECT_FALSE(open(folder_.path() / "none", true).start());
}

}  // namespace
}  // namespace aucast::server
