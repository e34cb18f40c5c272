#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/link/dialler.h"
#include "common/link/link.h"
#include "common/time.h"
#include "common/tls/context.h"
#include "protocol/endpoint.h"
#include "server/upstream/host_turns.h"

namespace aucast::server {

/// Dials the hosts of an address, one at a time and again for ever: the next one when one cannot be
/// reached or is lost, after the waits of HostTurns, and says why in the log.
/// Thread: that of the io_context, which must outlive it.
class Redialler {
 public:
  struct Options {
    std::vector<protocol::Endpoint> hosts;  ///< at least one
    std::optional<tls::Context> tls{};      ///< nothing: plain
    bool secret = false;    ///< a token will be shown: only over TLS or to this host
    int held_back_max = 0;  ///< of the links, as tcp_link() has it
    std::function<bool()> ready = [] { return true; };  ///< while it says no, nobody is dialled
  };
  using OnLink = std::function<void(std::shared_ptr<link::Link>)>;

  static constexpr Milliseconds kNotReady{500};  ///< how often it is asked whether it is ready

  /// `name`: what the log calls it, asked whenever there is something to say.
  Redialler(asio::io_context& io, Options options, std::function<std::string()> name,
            OnLink on_link);
  ~Redialler() { stop(); }
  Redialler(const Redialler&) = delete;
  Redialler& operator=(const Redialler&) = delete;

  void dial();
  void stop();
  /// The connection was of use: what failed before is forgotten.
  void worked();
  /// The connection is of no use, or no more: the next host is dialled, after a wait.
  void failed(const std::string& reason);
  /// Dials the same one again after that time.
  void again_in(Milliseconds wait);

  /// HOST:PORT of the one whose turn it is.
  [[nodiscard]] std::string peer() const;

 private:
  void on_dialled(link::Dialled dialled);

  Options options_;
  std::function<std::string()> name_;
  OnLink on_link_;
  HostTurns turns_;
  link::Dialler dialler_;
  asio::steady_timer timer_;
  bool stopped_ = false;
  std::vector<std::string> reasons_;  ///< said last of each host
};

}  // namespace aucast::server
