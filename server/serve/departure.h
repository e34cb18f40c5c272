#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include <asio/io_context.hpp>

#include "common/link/loop_timer.h"
#include "common/time.h"

namespace aucast::server {

/// How many of `clients` must have been sent away after `passed`, if all are sent away evenly
/// within `time`.
[[nodiscard]] std::size_t gone_by(std::size_t clients, Duration passed, Duration time);

/// Sends the clients of a server away, spread over a time, so that they do not all come to the next
/// server at once. Thread: that of the io_context, which must outlive it.
class Departure {
 public:
  using SendAway = std::function<void(std::size_t count)>;
  using OnOver = std::function<void()>;

  /// `send_away` is called with how many more to send away, `on_over` when the time is over.
  Departure(asio::io_context& io, SendAway send_away, OnOver on_over)
      : timer_(io), send_away_(std::move(send_away)), on_over_(std::move(on_over)) {}

  void begin(std::size_t clients, Duration time);
  /// Sends no more clients away, and does not call on_over.
  void stop() { timer_.cancel(); }

 private:
  void go_on();

  link::LoopTimer timer_;
  SendAway send_away_;
  OnOver on_over_;
  Instant begin_{};
  Duration time_{};
  std::size_t clients_ = 0;
  std::size_t gone_ = 0;
};

}  // namespace aucast::server
