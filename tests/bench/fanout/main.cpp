// How many deliveries a second of its processor's time au-transmitter makes to a crowd of live
// clients, and how late, beside publish/subscribe servers with the same crowd, rate and bytes.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

#include "common/command_line.h"
#include "tests/bench/fanout/measurement.h"

namespace {

using aucast::bench::Measurement;
using aucast::bench::Plan;

constexpr const char* kOurs = "au-transmitter";

aucast::Result<Plan> plan_from(int argc, char** argv, bool& help) {
  Plan plan;
  bool alone = false;
  CLI::App app("Measures how au-transmitter serves a crowd, as ratios to other servers.",
               "bench_fanout");
  app.add_option("--clients", plan.clients, "subscribers (1000)")->check(CLI::Range(1, 19000));
  app.add_option("--rate", plan.rate, "bursts a second (30)")->check(CLI::Range(0.1, 1000.0));
  app.add_option("--burst", plan.burst, "messages at once (1)")->check(CLI::Range(1, 256));
  app.add_option("--seconds", plan.seconds, "measured in each round (5)")
      ->check(CLI::Range(1, 3600));
  app.add_option("--rounds", plan.rounds, "of which the median counts (5)")
      ->check(CLI::Range(1, 100));
  app.add_option("--against", plan.against, "servers to compare with (redis mosquitto)");
  app.add_flag("--alone", alone, "compare with none");
  app.add_flag("--from-said", plan.from_said,
               "latency of the others from when their publisher said a message, not from its time");
  app.add_option("--flood", plan.flood,
                 "hostile connections at a time, and as many at --http; at ours only (0)")
      ->check(CLI::Range(0, 1000));
  auto parsed = aucast::parse_command_line(app, {argv + 1, argv + argc});
  help = app.get_help_ptr()->count() > 0;
  if (help) std::fputs(app.help().c_str(), stdout);
  if (!parsed && !help) return parsed.error();
  if (alone) plan.against.clear();
  return plan;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double load_average() {
  double load = 0;
  std::ifstream("/proc/loadavg") >> load;
  return load;
}

void print(int round, const std::string& server, const Measurement& m) {
  std::printf("%5d  %-15s %9.0f %10.0f %8.2f %8.2f %7.1f %7lld %6d %6.2f\n", round, server.c_str(),
              m.deliveries, m.per_processor_second(), m.p50_ms, m.p99_ms, m.bytes_per_client / 1024,
              static_cast<long long>(m.missed), m.disturbed, load_average());
  if (m.flood_peers > 0) {
    std::printf("       meanwhile %lld hostile peers, and %lld at --http, said %lld bytes\n",
                static_cast<long long>(m.flood_peers), static_cast<long long>(m.http_flood_peers),
                static_cast<long long>(m.flood_bytes));
  }
  std::fflush(stdout);
}

/// The median over the rounds of ours / theirs, as each round had them one after the other.
void print_ratios(const std::string& server, const std::vector<Measurement>& ours,
                  const std::vector<Measurement>& theirs) {
  std::vector<double> deliveries;
  std::vector<double> latency;
  for (std::size_t round = 0; round < theirs.size(); ++round) {
    deliveries.push_back(ours[round].per_processor_second() / theirs[round].per_processor_second());
    latency.push_back(ours[round].p99_ms / theirs[round].p99_ms);
  }
  std::printf("%s to %s, median of %zu: deliveries per CPU second x %.2f, p99 x %.2f\n", kOurs,
              server.c_str(), theirs.size(), median(deliveries), median(latency));
}

int run(const Plan& plan) {
  std::vector<std::string> servers{kOurs};
  servers.insert(servers.end(), plan.against.begin(), plan.against.end());
  std::map<std::string, std::vector<Measurement>> measured;
  std::printf("%d subscribers, %d messages at once every %d ms, %d s a round\n", plan.clients,
              plan.burst, plan.period_ms(), plan.seconds);
  std::printf(
      "round  server         deliveries per CPU s   p50 ms   p99 ms KiB/cl.  missed  lost"
      "   load\n");
  for (int round = 1; round <= plan.rounds; ++round) {
    for (const std::string& server : servers) {
      std::string failure;
      const auto measurement = aucast::bench::measure(server, plan, failure);
      if (!measurement) {
        std::fprintf(stderr, "bench_fanout: %s: %s\n", server.c_str(), failure.c_str());
        return 1;
      }
      print(round, server, *measurement);
      measured[server].push_back(*measurement);
    }
  }
  for (const std::string& server : plan.against) {
    print_ratios(server, measured[kOurs], measured[server]);
  }
  int disturbed = 0;
  for (const Measurement& measurement : measured[kOurs]) disturbed += measurement.disturbed;
  if (disturbed > 0) std::printf("%d subscribers of %s were disturbed\n", disturbed, kOurs);
  return disturbed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  bool help = false;
  const auto plan = plan_from(argc, argv, help);
  if (help) return 0;
  if (!plan) {
    std::fprintf(stderr, "bench_fanout: %s\n", plan.error().message.c_str());
    return aucast::exit_code(plan.error());
  }
  return run(plan.value());
}
