#pragma once

#include <cstdint>
#include <functional>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>

#include "common/time.h"
#include "server/serve/client_registry.h"
#include "server/serve/departure.h"

namespace aucast::server {

/// Longest time between the signal that ends the streams and the end: a client that is dead or does
/// not read is cut off then. The whole exit takes less than the promised two seconds.
inline constexpr Milliseconds kStopTimeMax{1700};

/// How a run comes to its end: SIGTERM or SIGINT, or stop(), ends the streams, and the last client
/// that leaves, kStopTimeMax or one more signal ends the run. With a drain time the first signal
/// sends the clients to other servers instead, until they are gone, the time is over or a second
/// signal comes; then the streams end. Thread: that of the io_context, which must outlive it
/// together with the registry and what the hooks refer to.
class Shutdown {
 public:
  enum class Phase : std::uint8_t {
    Serving,
    Leaving,   ///< clients are sent away, and nobody comes any more
    Stopping,  ///< the streams have ended, and what was sent still arrives
  };

  struct Hooks {
    std::function<void(Milliseconds at_most)> on_leave;  ///< how long all may take
    std::function<void()> on_stop;                       ///< clients are told by Shutdown
    std::function<void()> on_end;                        ///< nobody is here any more
  };

  /// `drain_time` 0: clients are not sent away.
  Shutdown(asio::io_context& io, Milliseconds drain_time, ClientRegistry& clients, Hooks hooks);
  Shutdown(const Shutdown&) = delete;
  Shutdown& operator=(const Shutdown&) = delete;

  [[nodiscard]] Phase phase() const { return phase_; }

  void await_signal();
  /// As if this signal had come.
  void on_signal(int number);
  /// Ends the streams, unless they have ended.
  void stop(const char* why);
  /// No client is left except servers that were dialled from here.
  void on_empty();

 private:
  void leave(const char* why);

  asio::signal_set signals_;
  asio::steady_timer timer_;
  Milliseconds drain_time_;
  ClientRegistry& clients_;
  Hooks hooks_;
  Departure departure_;
  Phase phase_ = Phase::Serving;
};

}  // namespace aucast::server
