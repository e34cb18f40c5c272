#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/status/stats.h"

namespace aucast::server {

/// A stream that comes from another server.
struct UpstreamStatus {
  std::string stream;      ///< empty: not known yet
  std::string parent;      ///< HOST:PORT; empty: none is connected
  bool receiving = false;  ///< keyframes have come from it
  std::uint64_t connects = 0;
  std::uint64_t losses = 0;             ///< of parents that had sent keyframes
  std::uint64_t keyframes = 0;          ///< received
  std::uint64_t bytes = 0;              ///< of the keyframes
  std::uint64_t captions_left_out = 0;  ///< too many were ahead of the face
};

/// A stream that is pushed to another server.
struct PushStatus {
  std::string stream;    ///< its name there
  std::string server;    ///< HOST:PORT of the host whose turn it is
  bool sending = false;  ///< it is being sent
  std::uint64_t connects = 0;
  std::uint64_t losses = 0;  ///< of connections on which the stream was taken
};

/// What came from an engine and was dropped.
struct EngineStatus {
  std::uint64_t messages_left_out = 0;   ///< too many waited for the event loop
  std::uint64_t batches_left_out = 0;    ///< too many waited for a missing batch
  std::uint64_t questions_left_out = 0;  ///< too many came in one second
};

/// The state of a transmitter at one moment, which SIGUSR1 logs and --http answers.
struct Status {
  double up_seconds = 0;
  bool live = false;
  bool stopping = false;               ///< clients are no longer accepted
  std::vector<std::string> streams;    ///< names; the first is what a classic client gets
  std::uint64_t clients = 0;           ///< connected now
  std::uint64_t clients_web = 0;       ///< of `clients`, by WebSocket
  std::uint64_t clients_paused = 0;    ///< of `clients`
  std::uint64_t clients_behind = 0;    ///< of `clients`, with bytes that wait to be taken
  std::uint64_t connects = 0;          ///< since the start
  std::uint64_t connects_unheard = 0;  ///< closed at once, without room even for a refusal
  std::uint64_t accept_failures = 0;   ///< out of descriptors or memory
  std::uint64_t wrong_tokens = 0;      ///< of viewers and publishers
  std::map<std::string, std::uint64_t> disconnects;  ///< since the start, by reason
  Totals totals;                          ///< sent to all, past and present, and by --push
  std::size_t queue_bytes = 0;            ///< bytes that wait to be taken
  double queue_seconds = 0;               ///< longest time for which a client has taken none
  double lag_seconds = 0;                 ///< how late the latest live moment was sent
  std::uint64_t reloads = 0;              ///< by SIGHUP
  std::uint64_t reload_failures = 0;      ///< by SIGHUP, which took over nothing
  std::vector<UpstreamStatus> upstreams;  ///< one for each stream of another server
  std::vector<PushStatus> pushes;         ///< one for each --push
  std::optional<EngineStatus> engine;     ///< nullopt: none is in use
};

/// The lines for the log; the first has the most important numbers.
[[nodiscard]] std::vector<std::string> status_lines(const Status& status);

/// The status in Prometheus' text format 0.0.4.
[[nodiscard]] std::string metrics_text(const Status& status);

/// The status as one JSON object, with a newline at its end.
[[nodiscard]] std::string status_json(const Status& status);

}  // namespace aucast::server
