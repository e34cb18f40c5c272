#pragma once

#include <optional>
#include <string>

#include "tests/bench/fanout/plan.h"

namespace aucast::bench {

/// What one server did in one round.
struct Measurement {
  double deliveries = 0;         ///< messages that reached a subscriber in the time measured
  double processor_seconds = 0;  ///< of the server in that time
  double p50_ms = 0;             ///< from when a message was due until its subscriber has read it
  double p99_ms = 0;
  double arrived_p99_ms = 0;    ///< from when it was due until the system has it for the subscriber
  double bytes_per_client = 0;  ///< the server's own memory
  double added_p50_ms = 0;      ///< of a tree: how much edges' subscribers lag behind the root's
  double added_p99_ms = 0;
  double root_seconds = 0;    ///< of a tree: the root's part of processor_seconds
  double bytes_per_edge = 0;  ///< of a tree: memory of an edge that has no subscribers
  std::int64_t missed = 0;    ///< messages left out, doubled or out of order
  int disturbed = 0;          ///< subscribers who lost their connection
  std::int64_t flood_peers = 0;
  std::int64_t http_flood_peers = 0;
  std::int64_t flood_bytes = 0;

  [[nodiscard]] double per_processor_second() const { return deliveries / processor_seconds; }
};

/// Starts the server, gathers the subscribers, measures, ends the server. nullopt, with `failure`,
/// when any of that fails.
[[nodiscard]] std::optional<Measurement> measure(const std::string& server, const Plan& plan,
                                                 std::string& failure);

}  // namespace aucast::bench
