#pragma once

#include <functional>
#include <string>

#include <asio/io_context.hpp>

#include "common/link/loop_timer.h"
#include "common/time.h"
#include "server/status/service_manager.h"

namespace aucast::server {

/// Tells the service manager, if there is one, when a run starts, reloads and stops. Also sends it,
/// again and again, the run's status and the sign that the event loop is alive. Thread: that of the
/// io_context. The io_context and what `summary` refers to must both outlive this object.
class ServiceBeat {
 public:
  /// How often the status is sent, unless the manager wants to hear more often that we are alive.
  static constexpr Milliseconds kStatusEvery{10'000};

  /// `summary` returns the status in one line.
  ServiceBeat(asio::io_context& io, std::function<std::string()> summary)
      : timer_(io), summary_(std::move(summary)) {}
  ServiceBeat(const ServiceBeat&) = delete;
  ServiceBeat& operator=(const ServiceBeat&) = delete;

  /// Call when clients can connect.
  void begin();
  void reloading() const { manager_.reloading(); }
  void reloaded() const { manager_.ready(summary_()); }
  /// `at_most`: how long stopping may take; zero: as long as the manager is configured to wait.
  void stopping(Milliseconds at_most) const { manager_.stopping(at_most); }

 private:
  void beat();

  ServiceManager manager_;
  link::LoopTimer timer_;
  std::function<std::string()> summary_;
};

}  // namespace aucast::server
