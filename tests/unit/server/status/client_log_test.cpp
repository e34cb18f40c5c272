#include "server/status/client_log.h"

#include <chrono>
#include <sstream>

#include <gtest/gtest.h>

#include "server/settings/limits.h"
#include "tests/support/kept_log.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

class ClientLogTest : public ::testing::Test {
 protected:
  /// So many lines at a moment.
  void say(Duration at, std::uint64_t count) {
    for (std::uint64_t line = 0; line < count; ++line) {
      log_.say(Instant(1h) + at, spdlog::level::info, "client {}", line);
    }
  }

  /// Lines of clients so far; the others are `rest_`.
  std::uint64_t count() {
    std::istringstream lines(kept_.said());
    std::uint64_t clients = 0;
    rest_.clear();
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("client ")) {
        ++clients;
      } else {
        rest_ += line + "\n";
      }
    }
    return clients;
  }

  ClientLog log_;
  std::string rest_;

 private:
  const test::KeptLog kept_;
};

constexpr std::uint64_t kMost = kClientLogLinesPerSecond;

TEST_F(ClientLogTest, OrdinaryTrafficIsSaidWhole) {
  for (int second = 0; second < 5; ++second) say(second * 1s, kMost);
  log_.say_left_out();
  EXPECT_EQ(count(), 5 * kMost);
  EXPECT_EQ(rest_, "");
}

TEST_F(ClientLogTest, OfAFloodTheRestIsCountedAndSaidWhenItIsOver) {
  say(0s, kMost + 1);
  say(999ms, 41);
  EXPECT_EQ(count(), kMost);
  EXPECT_EQ(rest_, "");
  say(1s, 1);
  EXPECT_EQ(count(), kMost + 1);
  EXPECT_TRUE(rest_.starts_with("42 lines about clients were left out here")) << rest_;
  say(1500ms, kMost);
  log_.say_left_out();
  EXPECT_EQ(count(), 2 * kMost);
  EXPECT_NE(rest_.find("\n1 lines about clients"), std::string::npos) << rest_;
  log_.say_left_out();
  const std::string rest = rest_;
  EXPECT_EQ(count(), 2 * kMost);
  EXPECT_EQ(rest_, rest) << "said once";
}

TEST_F(ClientLogTest, WhatTheLevelHidesIsNotLeftOut) {
  spdlog::default_logger()->set_level(spdlog::level::warn);
  say(0s, 10 * kMost);
  log_.say_left_out();
  EXPECT_EQ(count(), 0U);
  EXPECT_EQ(rest_, "");
}

TEST_F(ClientLogTest, NothingIsLeftOutForWhoLooksForAFault) {
  spdlog::default_logger()->set_level(spdlog::level::debug);
  say(0s, 10 * kMost);
  log_.say_left_out();
  EXPECT_EQ(count(), 10 * kMost);
  EXPECT_EQ(rest_, "");
}

}  // namespace
}  // namespace aucast::server
