#pragma once

#include <optional>
#include <string>

#include "tests/bench/fanout/plan.h"

namespace aucast::bench {

/// What one server did in one round.
struct Measurement {
  double deliveries = 0;         ///< messages that arrived at a subscriber in the time measured
  double processor_seconds = 0;  ///< of the server in that time
  double p50_ms = 0;             ///< from being due to being read by the subscriber
  double p99_ms = 0;
  double arrived_p99_ms = 0;    ///< to being there for the subscriber to read
  double bytes_per_client = 0;  ///< memory of the server's own
  double added_p50_ms = 0;      ///< of a tree: at a subscriber of an edge after one of the root
  double added_p99_ms = 0;
  double root_seconds = 0;    ///< of a tree: the root's part of processor_seconds
  double bytes_per_edge = 0;  ///< of a tree: memory of an edge without a crowd
  std::int64_t missed = 0;    ///< messages left out, doubled or out of order
  int disturbed = 0;          ///< subscribers who lost their connection
  std::int64_t flood_peers = 0;
  std::int64_t http_flood_peers = 0;
  std::int64_t flood_bytes = 0;

  [[nodiscard]] double per_processor_second() const { return deliveries / processor_seconds; }
};

/// Starts the server, gathers the subscribers, measures, ends the server. Nothing, with `failure`,
/// when that does not come about.
[[nodiscard]] std::optional<Measurement> measure(const std::string& server, const Plan& plan,
                                                 std::string& failure);

}  // namespace aucast::bench
