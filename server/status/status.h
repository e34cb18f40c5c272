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
  std::uint64_t losses = 0;     ///< of a parent that sent
  std::uint64_t keyframes = 0;  ///< received
  std::uint64_t bytes = 0;      ///< of those
};

/// A stream that is brought to another server.
struct PushStatus {
  std::string stream;    ///< its name there
  std::string server;    ///< HOST:PORT of the one whose turn it is
  bool sending = false;  ///< it is taken there
  std::uint64_t connects = 0;
  std::uint64_t losses = 0;  ///< of those
};

/// What an engine brought that was not worked on.
struct EngineStatus {
  std::uint64_t messages_left_out = 0;   ///< no room to wait for the event loop
  std::uint64_t batches_left_out = 0;    ///< no room to wait for what was missing before them
  std::uint64_t questions_left_out = 0;  ///< more than are answered in a second
};

/// How a transmitter is at one moment: what SIGUSR1 logs and --http answers.
struct Status {
  double up_seconds = 0;
  bool live = false;
  bool stopping = false;               ///< nobody is accepted any more
  std::vector<std::string> streams;    ///< names; the first is what a classic client gets
  std::uint64_t clients = 0;           ///< connected now
  std::uint64_t clients_web = 0;       ///< of those: by WebSocket
  std::uint64_t clients_paused = 0;    ///< of those
  std::uint64_t clients_behind = 0;    ///< of those: something waits for them to take it
  std::uint64_t connects = 0;          ///< since the start
  std::uint64_t connects_unheard = 0;  ///< closed at once: not even room for a refusal
  std::uint64_t accept_failures = 0;   ///< out of descriptors or memory
  std::map<std::string, std::uint64_t> disconnects;  ///< by reason, since the start
  Totals sent;                            ///< to all clients, those that are here among them
  std::size_t queue_bytes = 0;            ///< that wait for clients to take them
  double queue_seconds = 0;               ///< longest time that anything waits for one client
  double lag_seconds = 0;                 ///< how late the latest live moment was sent
  std::uint64_t reloads = 0;              ///< by SIGHUP, that worked
  std::uint64_t reload_failures = 0;      ///< something was not taken over
  std::vector<UpstreamStatus> upstreams;  ///< one for each stream of another server
  std::vector<PushStatus> pushes;         ///< one for each --push
  std::optional<EngineStatus> engine;     ///< nothing: none is in use
};

/// For the log; the first line says the most.
[[nodiscard]] std::vector<std::string> status_lines(const Status& status);

/// Prometheus' text format 0.0.4.
[[nodiscard]] std::string metrics_text(const Status& status);

/// One JSON object, with a newline at its end.
[[nodiscard]] std::string status_json(const Status& status);

}  // namespace aucast::server
