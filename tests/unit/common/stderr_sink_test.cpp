// A log that nobody reads.
#include "common/stderr_sink.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <climits>

#include <gtest/gtest.h>
#include <spdlog/logger.h>

namespace aucast {
namespace {

class StderrSinkTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(::pipe2(pipe_.data(), O_CLOEXEC), 0);
    auto sink = std::make_shared<StderrSink>(pipe_[1], false);
    logger_ = std::make_shared<spdlog::logger>("log", sink);
    logger_->set_pattern("%v");
  }
  void TearDown() override {
    ::close(pipe_[0]);
    ::close(pipe_[1]);
  }

  /// Everything that is in the pipe.
  std::string read_all() {
    const int flags = ::fcntl(pipe_[0], F_GETFL);
    ::fcntl(pipe_[0], F_SETFL, flags | O_NONBLOCK);
    std::string all;
    std::array<char, 4096> chunk{};
    for (ssize_t got = 0; (got = ::read(pipe_[0], chunk.data(), chunk.size())) > 0;) {
      all.append(chunk.data(), static_cast<std::size_t>(got));
    }
    return all;
  }

  std::array<int, 2> pipe_{};
  std::shared_ptr<spdlog::logger> logger_;
};

TEST_F(StderrSinkTest, WhatDoesNotFitIsDroppedCountedAndSaid) {
  const std::string line(999, 'x');
  // The test would hang here if a full pipe were waited for.
  for (int i = 0; i < 1000; ++i) logger_->info(line);
  const std::string first = read_all();
  const std::size_t kept = first.size() / 1000;
  EXPECT_EQ(first.size() % 1000, 0U);
  EXPECT_GE(kept, 15U);
  EXPECT_LT(kept, 1000U);
  logger_->info("read again");
  EXPECT_EQ(read_all(), std::to_string(1000 - kept) +
                            " lines of the log were dropped here: nobody read them\nread again\n");
  logger_->info("and on");
  EXPECT_EQ(read_all(), "and on\n");
}

TEST_F(StderrSinkTest, ALongLineIsCutToWhatAPipeTakesAtOnce) {
  logger_->info(std::string(10'000, 'x'));
  const std::string line = read_all();
  EXPECT_EQ(line.size(), static_cast<std::size_t>(PIPE_BUF));
  EXPECT_TRUE(line.ends_with("x\n"));
}

TEST_F(StderrSinkTest, TheDescriptorStaysBlockingForOthers) {
  logger_->info("line");
  EXPECT_EQ(::fcntl(pipe_[1], F_GETFL) & O_NONBLOCK, 0);
}

}  // namespace
}  // namespace aucast
