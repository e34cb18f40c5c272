#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "tests/bench/fanout/plan.h"
#include "tests/bench/fanout/server_under_test.h"

namespace aucast::bench {

/// Says the messages of a plan to a publish/subscribe server, on a thread of its own.
class Publisher {
 public:
  Publisher(const Plan& plan, const ServerUnderTest& server, std::int64_t messages_max);
  ~Publisher() { stop(); }
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;

  void stop();
  /// When a message was due to be handed to the system. Call it after stop().
  [[nodiscard]] Clock::time_point due(std::int64_t number) const {
    return begin_ + plan_.place(number);
  }
  /// When the message was handed to the system. Call it after stop(), for messages that have
  /// arrived.
  [[nodiscard]] Clock::time_point said(std::int64_t number) const {
    return said_[static_cast<std::size_t>(number)];
  }

 private:
  void run(const Dialect& dialect, std::uint16_t port);

  Plan plan_;
  Clock::time_point begin_;
  std::vector<Clock::time_point> said_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace aucast::bench
