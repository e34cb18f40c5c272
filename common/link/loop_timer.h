#pragma once

#include <system_error>
#include <utility>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/time.h"
#include "common/waits.h"

namespace aucast::link {

/// Wakes its owner in an event loop, for one thing at a time. What it is set for takes the place of
/// what it was set for before. A handler that is already queued when it is cancelled, set anew or
/// destroyed does nothing.
/// Thread: that of the io_context, which must outlive it.
class LoopTimer {
 public:
  explicit LoopTimer(asio::io_context& io) : timer_(io) {}

  /// Calls `wake` once, at `when` or as soon as the loop gets to it.
  template <typename Wake>
  void at(Instant when, Wake wake) {
    timer_.expires_at(when);
    await(std::move(wake));
  }
  template <typename Wake>
  void after(Duration time, Wake wake) {
    timer_.expires_after(time);
    await(std::move(wake));
  }
  void cancel() {
    waits_.cancel();
    timer_.cancel();
  }
  /// The last `when`; the epoch if there was none.
  [[nodiscard]] Instant when() const { return timer_.expiry(); }

 private:
  template <typename Wake>
  void await(Wake wake) {
    timer_.async_wait(
        [wait = waits_.begin(), wake = std::move(wake)](const std::error_code& /*cancelled*/) {
          if (wait.current()) wake();
        });
  }

  asio::steady_timer timer_;
  Waits waits_;
};

}  // namespace aucast::link
