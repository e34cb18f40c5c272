#pragma once

#include <functional>
#include <optional>
#include <string>

#include "common/result.h"
#include "server/serve/reload.h"
#include "server/settings/transmitter_options.h"
#include "server/status/stats.h"
#include "server/streams/repertoire.h"

namespace aucast::server {

/// The addresses at which clients can connect, as ADDR:PORT.
struct ReadyAt {
  std::string address;
  std::string web;            ///< of --web; empty: there is none
  std::string owner_token{};  ///< what clients must show at `address`; empty: that is for anybody
};

/// Called when clients can connect; an error ends serve() before any is accepted.
using OnReady = std::function<Result<void>(const ReadyAt& where)>;

/// How serving ended.
struct RunResult {
  std::optional<Error> error;  ///< an error that did not end serving, such as a failed --record
};

/// Serves the repertoire, recorded or live, to any number of clients until SIGTERM or SIGINT. From
/// then on nobody is accepted. With a drain time, clients are first sent to other servers. Then the
/// streams end, and serve() returns when the last client is gone or the time for that is over. Each
/// further signal begins the next of these steps at once (Shutdown). The streams end in the same
/// way when all are live and nothing can come any more, as after the end of stdin. SIGHUP calls
/// `load` on another thread and serves what it returns to clients that connect from then on;
/// earlier ones keep what they have. A load that is under way at the end is asked to stop. SIGUSR1
/// logs the status. SIGPIPE is ignored from here on. Thread: one, the caller's.
[[nodiscard]] Result<RunResult> serve(const TransmitterOptions& options, Repertoire repertoire,
                                      Stats& stats, const OnReady& on_ready, Reload::Load load);

}  // namespace aucast::server
