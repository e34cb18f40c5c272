#include "common/thread.h"

#include <chrono>
#include <stop_token>

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(SleepUntil, EndsAtItsTimeOrWhenAStopIsRequested) {
  const std::stop_source asked;
  const Instant begin = std::chrono::steady_clock::now();
  sleep_until(asked.get_token(), begin + Milliseconds(5));
  EXPECT_GE(std::chrono::steady_clock::now(), begin + Milliseconds(5));
  auto sleeper = start_thread([](const std::stop_token& stop) {
    sleep_until(stop, std::chrono::steady_clock::now() + std::chrono::hours(1));
  });
  ASSERT_TRUE(sleeper);
  sleeper->request_stop();
  sleeper->join();
}

}  // namespace
}  // namespace aucast
