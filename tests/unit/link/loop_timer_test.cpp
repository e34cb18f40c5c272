#include "common/link/loop_timer.h"

#include <chrono>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <gtest/gtest.h>
#include <asio/steady_timer.hpp>

namespace aucast::link {
namespace {

using namespace std::chrono_literals;

class LoopTimerTest : public ::testing::Test {
 protected:
  /// Sets the timer for a time that has passed, so that its handler is queued as soon as the loop
  /// runs.
  void set_for_now(const std::string& what) {
    timer_->at(std::chrono::steady_clock::now() - 1h, [this, what] { woken_ += what; });
  }
  /// Does something between the moment when the handler is queued and its call.
  template <typename Act>
  void while_queued(Act act) {
    asio::steady_timer first(io_, std::chrono::steady_clock::now() - 2h);
    first.async_wait([act](const std::error_code& /*error*/) { act(); });
    set_for_now("a");
    io_.run();
  }

  asio::io_context io_;
  std::optional<LoopTimer> timer_{std::in_place, io_};
  std::string woken_;
};

TEST_F(LoopTimerTest, WakesOnce) {
  set_for_now("a");
  io_.run();
  EXPECT_EQ(woken_, "a");
}

TEST_F(LoopTimerTest, WhatItIsSetForReplacesWhatItWasSetFor) {
  timer_->after(1h, [this] { woken_ += "never"; });
  timer_->after(0ms, [this] { woken_ += "b"; });
  io_.run();
  EXPECT_EQ(woken_, "b");
}

TEST_F(LoopTimerTest, AQueuedHandlerDoesNothingAfterCancel) {
  while_queued([this] { timer_->cancel(); });
  EXPECT_EQ(woken_, "");
}

TEST_F(LoopTimerTest, AQueuedHandlerDoesNothingOnceTheTimerIsSetAnew) {
  while_queued([this] { set_for_now("b"); });
  EXPECT_EQ(woken_, "b");
}

TEST_F(LoopTimerTest, AQueuedHandlerDoesNothingOnceTheTimerIsGone) {
  while_queued([this] { timer_.reset(); });
  EXPECT_EQ(woken_, "");
}

TEST_F(LoopTimerTest, TellsWhenItWakes) {
  const Instant when = std::chrono::steady_clock::now() + 1h;
  EXPECT_EQ(timer_->when(), Instant());
  timer_->at(when, [] {});
  EXPECT_EQ(timer_->when(), when);
}

}  // namespace
}  // namespace aucast::link
