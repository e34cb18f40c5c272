#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/descriptor.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::server {

/// Talks to a service manager such as systemd by sd_notify(3)'s protocol: datagrams to the socket
/// that $NOTIFY_SOCKET names. Without a manager it does nothing.
class ServiceManager {
 public:
  ServiceManager();  ///< from the environment
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  /// Whether there is a service manager.
  [[nodiscard]] bool present() const { return socket_.open(); }

  void ready(const std::string& status) const;
  /// A reload has begun; it lasts until the next ready().
  void reloading() const;
  /// `at_most`: how long stopping may take; zero: as long as the manager is configured to wait.
  void stopping(Milliseconds at_most) const;
  void status(const std::string& status) const;
  void alive() const;

  /// The longest time between two calls of alive(); nullopt: the manager does not expect them.
  [[nodiscard]] std::optional<Duration> watchdog() const { return watchdog_; }

 private:
  /// May: a message that will soon be repeated, which is dropped when the manager is too busy.
  enum class Need : std::uint8_t { May, Must };
  void say(std::string_view message, Need need) const;

  Descriptor socket_;
  std::string address_;  ///< as in $NOTIFY_SOCKET
  std::optional<Duration> watchdog_;
};

/// The listening socket that was passed to us by sd_listen_fds(3)'s protocol (LISTEN_PID,
/// LISTEN_FDS); nullopt: none was passed. Fails with a Usage error if several were passed, or if
/// the socket is not a listening TCP socket. Call it once: the caller then owns the socket.
[[nodiscard]] Result<std::optional<int>> passed_socket();

}  // namespace aucast::server
