#pragma once

#include <functional>
#include <string>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/time.h"
#include "server/status/service_manager.h"

namespace aucast::server {

/// Tells the service manager, if there is one, where a run is, and again and again that its loop
/// goes round and how it is. Thread: that of the io_context, which must outlive it together with
/// what `summary` refers to.
class ServiceBeat {
 public:
  /// How often it hears of the status, unless it wants to hear more often that we are alive.
  static constexpr Milliseconds kStatusEvery{10'000};

  /// `summary`: one line.
  ServiceBeat(asio::io_context& io, std::function<std::string()> summary)
      : timer_(io), summary_(std::move(summary)) {}
  ServiceBeat(const ServiceBeat&) = delete;
  ServiceBeat& operator=(const ServiceBeat&) = delete;

  /// Clients can come.
  void begin();
  void reloading() const { manager_.reloading(); }
  void reloaded() const { manager_.ready(summary_()); }
  /// `at_most`: how long it may take; zero: what the manager is set to.
  void stopping(Milliseconds at_most) const { manager_.stopping(at_most); }

 private:
  void beat();

  ServiceManager manager_;
  asio::steady_timer timer_;
  std::function<std::string()> summary_;
};

}  // namespace aucast::server
