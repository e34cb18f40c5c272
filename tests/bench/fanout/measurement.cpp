#include "tests/bench/fanout/measurement.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_map>
#include <vector>

#include "tests/bench/fanout/crowd.h"
#include "tests/bench/fanout/flood.h"
#include "tests/bench/fanout/publisher.h"
#include "tests/bench/fanout/server_tree.h"

namespace aucast::bench {
namespace {

using namespace std::chrono_literals;

/// A stream says no absolute time, so its beginning is taken from who gets it quickest: one
/// subscriber alone, before the others come. All latencies are short by that quickest delivery,
/// some tenth of a millisecond.
Clock::time_point beginning(const std::vector<Delivery>& alone, const Plan& plan) {
  auto begin = Clock::time_point::max();
  for (const Delivery& delivery : alone) {
    begin = std::min(begin, delivery.arrived - plan.place(delivery.number));
  }
  return begin;
}

double percentile(std::vector<double>& sorted, double part) {
  if (sorted.empty()) return NAN;
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

/// The first subscriber is the root's: how much later the others had what it had.
void add_delays(const std::vector<Delivery>& deliveries, Measurement& result) {
  std::unordered_map<std::int64_t, Clock::time_point> at_root;
  for (const Delivery& delivery : deliveries) {
    if (delivery.subscriber == 0) at_root.emplace(delivery.number, delivery.arrived);
  }
  std::vector<double> added;
  for (const Delivery& delivery : deliveries) {
    const auto root = at_root.find(delivery.number);
    if (delivery.subscriber == 0 || root == at_root.end()) continue;
    added.push_back(
        std::chrono::duration<double, std::milli>(delivery.arrived - root->second).count());
  }
  std::sort(added.begin(), added.end());
  result.added_p50_ms = percentile(added, 0.5);
  result.added_p99_ms = percentile(added, 0.99);
}

/// From when each message was due (or said) at the server, which began at `begin` if it publishes
/// by itself.
void add_latencies(const std::vector<Delivery>& deliveries, const Plan& plan,
                   Clock::time_point begin, const Publisher* publisher, Measurement& result) {
  std::vector<double> arrived;
  std::vector<double> read;
  arrived.reserve(deliveries.size());
  read.reserve(deliveries.size());
  for (const Delivery& delivery : deliveries) {
    auto said = begin + plan.place(delivery.number);
    if (publisher != nullptr) {
      said = plan.from_said ? publisher->said(delivery.number) : publisher->due(delivery.number);
    }
    arrived.push_back(std::chrono::duration<double, std::milli>(delivery.arrived - said).count());
    read.push_back(std::chrono::duration<double, std::milli>(delivery.read - said).count());
  }
  std::sort(arrived.begin(), arrived.end());
  std::sort(read.begin(), read.end());
  result.p50_ms = percentile(read, 0.5);
  result.p99_ms = percentile(read, 0.99);
  result.arrived_p99_ms = percentile(arrived, 0.99);
}

}  // namespace

std::optional<Measurement> measure(const std::string& name, const Plan& plan,
                                   std::string& failure) {
  const ServerTree tree(name, plan);
  const ServerUnderTest& server = tree.root();
  failure = tree.failure();
  if (!failure.empty()) return std::nullopt;
  const bool publishes_itself = server.dialect().wrap == nullptr;
  const long bytes_before = tree.private_bytes();
  const long root_bytes_before = server.private_bytes();

  Crowd crowd(server.dialect());
  std::vector<Delivery> alone;
  bool ready = crowd.join(1, server.port());
  if (publishes_itself) crowd.listen(Clock::now() + 1s, &alone);
  ready = ready && tree.gather(crowd, plan.clients - 1) && crowd.wait_for_welcome(30s);
  if (!ready || (publishes_itself && alone.empty())) {
    failure = crowd.failure().empty() ? "not all subscribers were welcomed" : crowd.failure();
    return std::nullopt;
  }
  std::unique_ptr<Publisher> publisher;
  const auto bursts = (plan.seconds + 60) * 1000LL / plan.period_ms();
  if (!publishes_itself) publisher = std::make_unique<Publisher>(plan, server, bursts * plan.burst);

  Measurement result;
  Flood flood(server.port(), publishes_itself ? plan.flood : 0);
  Flood http_flood(server.http_port(), server.http_port() != 0 ? plan.flood : 0);
  crowd.listen(Clock::now() + 1s, nullptr);
  // What was left out while they gathered is not the question.
  const std::int64_t missed_before = crowd.missed();
  std::vector<Delivery> deliveries;
  deliveries.reserve(
      static_cast<std::size_t>(plan.rate * plan.burst * plan.clients * (plan.seconds + 1)));
  const std::int64_t peers_before = flood.peers();
  const std::int64_t http_peers_before = http_flood.peers();
  const std::int64_t bytes_before_flood = flood.bytes() + http_flood.bytes();
  const auto processor_before = tree.processor_time();
  const auto root_before = server.processor_time();
  crowd.listen(Clock::now() + std::chrono::seconds(plan.seconds), &deliveries);
  const auto processor_after = tree.processor_time();
  const auto root_after = server.processor_time();

  result.bytes_per_client = static_cast<double>(tree.private_bytes() - bytes_before) / plan.clients;
  result.flood_peers = flood.peers() - peers_before;
  result.http_flood_peers = http_flood.peers() - http_peers_before;
  result.flood_bytes = flood.bytes() + http_flood.bytes() - bytes_before_flood;
  if (publisher) publisher->stop();
  result.deliveries = static_cast<double>(deliveries.size());
  result.processor_seconds =
      std::chrono::duration<double>(processor_after - processor_before).count();
  if (plan.edges > 0) {
    result.root_seconds = std::chrono::duration<double>(root_after - root_before).count();
    result.bytes_per_edge = static_cast<double>(bytes_before - root_bytes_before) / plan.edges;
    add_delays(deliveries, result);
  }
  result.missed = crowd.missed() - missed_before;
  result.disturbed = crowd.disturbed();
  add_latencies(deliveries, plan, beginning(alone, plan), publisher.get(), result);
  return result;
}

}  // namespace aucast::bench
