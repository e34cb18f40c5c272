#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"
#include "common/time.h"

namespace aucast::server {

/// Talks to a service manager such as systemd, by sd_notify(3)'s protocol: datagrams to the socket
/// that $NOTIFY_SOCKET names. Without one nothing happens.
class ServiceManager {
 public:
  ServiceManager();  ///< from the environment
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  /// Somebody listens.
  [[nodiscard]] bool present() const { return socket_ >= 0; }

  void ready(const std::string& status) const;
  /// Until the next ready().
  void reloading() const;
  /// `at_most`: how long stopping may take; zero: what the service manager is set to.
  void stopping(Milliseconds at_most) const;
  void status(const std::string& status) const;
  void alive() const;

  /// How often alive() must be said at least; nothing: nobody waits for it.
  [[nodiscard]] std::optional<Duration> watchdog() const { return watchdog_; }

 private:
  /// What comes again soon may be dropped when the manager is too busy to take it.
  enum class Need : std::uint8_t { May, Must };
  void say(std::string_view message, Need need) const;

  int socket_ = -1;
  std::string address_;  ///< as in $NOTIFY_SOCKET
  std::optional<Duration> watchdog_;
};

/// The listening socket that was passed by sd_listen_fds(3)'s protocol (LISTEN_PID, LISTEN_FDS), or
/// nothing. Usage error when there are more, or it is no listening TCP socket. Asked once: it
/// belongs to the caller then.
[[nodiscard]] Result<std::optional<int>> passed_socket();

}  // namespace aucast::server
