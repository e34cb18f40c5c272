#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>

#include "common/link/dialler.h"
#include "common/link/link.h"
#include "common/link/loop_timer.h"
#include "common/time.h"
#include "common/tls/context.h"
#include "protocol/endpoint.h"
#include "server/upstream/host_turns.h"

namespace aucast::server {

/// Dials the hosts of an address one at a time, without end. When one cannot be reached or is lost,
/// logs why and dials the next one, after the wait of HostTurns.
/// Thread: that of the io_context, which must outlive it.
class Redialler {
 public:
  struct Options {
    std::vector<protocol::Endpoint> hosts;  ///< at least one
    std::optional<tls::Context> tls{};      ///< nullopt: no TLS
    bool secret = false;                    ///< see link::DialOptions
    int held_back_max = 0;                  ///< see link::tcp_link()
    /// While it returns false, no host is dialled.
    std::function<bool()> ready = [] { return true; };
  };
  using OnLink = std::function<void(std::shared_ptr<link::Link>)>;

  static constexpr Milliseconds kNotReady{500};  ///< the wait between two calls of `ready`

  /// `name` is called for each line of the log, which begins with the name that it returns.
  Redialler(asio::io_context& io, Options options, std::function<std::string()> name,
            OnLink on_link);
  ~Redialler() { stop(); }
  Redialler(const Redialler&) = delete;
  Redialler& operator=(const Redialler&) = delete;

  void dial();
  void stop();
  /// Call when a connection was of use: earlier failures are forgotten.
  void worked();
  /// Call when a connection was refused or lost: the next host is dialled, after a wait.
  void failed(const std::string& reason);
  /// Dials the same host again after this time.
  void again_in(Milliseconds wait);

  /// HOST:PORT of the host whose turn it is.
  [[nodiscard]] std::string peer() const;

 private:
  void on_dialled(link::Dialled dialled);

  Options options_;
  std::function<std::string()> name_;
  OnLink on_link_;
  HostTurns turns_;
  link::Dialler dialler_;
  link::LoopTimer timer_;  ///< before the next host
  bool stopped_ = false;
  std::vector<std::string> reasons_;  ///< for each host, the reason that was last logged
};

}  // namespace aucast::server
