#pragma once

#include <cstdint>
#include <functional>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>

#include "common/link/loop_timer.h"
#include "common/time.h"
#include "server/serve/client_registry.h"
#include "server/serve/departure.h"

namespace aucast::server {

/// The longest time from the signal that ends the streams to the end of the run; clients that are
/// left then are cut off. The whole exit takes less than the promised two seconds.
inline constexpr Milliseconds kStopTimeMax{1700};

/// Ends a run. SIGTERM, SIGINT or stop() ends the streams; then the run ends when the last client
/// has left, after kStopTimeMax, or on another signal. With a drain time, the first signal sends
/// the clients to other servers instead, until they have left, the time is over or a second signal
/// comes; then the streams end. Thread: that of the io_context. The io_context, the registry and
/// what the hooks refer to must outlive this object.
class Shutdown {
 public:
  enum class Phase : std::uint8_t {
    Serving,
    Leaving,   ///< clients are sent away, and no more are accepted
    Stopping,  ///< the streams have ended; clients receive what was sent
  };

  struct Hooks {
    /// Clients begin to be sent away. `at_most`: how long it may take until the run ends.
    std::function<void(Milliseconds at_most)> on_leave;
    std::function<void()> on_stop;  ///< the streams end; Shutdown tells the clients itself
    std::function<void()> on_end;   ///< no client is left
  };

  /// `drain_time` 0: clients are not sent away.
  Shutdown(asio::io_context& io, Milliseconds drain_time, ClientRegistry& clients, Hooks hooks);
  Shutdown(const Shutdown&) = delete;
  Shutdown& operator=(const Shutdown&) = delete;

  [[nodiscard]] Phase phase() const { return phase_; }

  void await_signal();
  /// Acts as if this signal had come.
  void on_signal(int number);
  /// Ends the streams, unless they have ended. `why` is for the log.
  void stop(const char* why);
  /// Call when no client is left except servers that we have dialled.
  void on_empty();

 private:
  void leave(const char* why);

  asio::signal_set signals_;
  link::LoopTimer timer_;
  Milliseconds drain_time_;
  ClientRegistry& clients_;
  Hooks hooks_;
  Departure departure_;
  Phase phase_ = Phase::Serving;
};

}  // namespace aucast::server
