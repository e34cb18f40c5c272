// How many deliveries a second of its processor's time au-transmitter makes to a crowd of live
// clients, and how late, beside publish/subscribe servers with the same crowd, rate and bytes.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "common/command_line.h"
#include "tests/bench/fanout/measurement.h"
#include "tests/bench/fanout/processors.h"

namespace {

using aucast::bench::kOurs;
using aucast::bench::Measurement;
using aucast::bench::OnProcessor;
using aucast::bench::Plan;
using aucast::bench::usable_processors;

constexpr const char* kFlooded = "flooded";  ///< the same
constexpr const char* kNats = "nats";
constexpr const char* kWeb = "by WebSocket";  ///< the same

aucast::Result<Plan> plan_from(int argc, char** argv, bool& help) {
  Plan plan;
  bool alone = false;
  bool pin = false;
  CLI::App app("Measures how au-transmitter serves a crowd, as ratios to other servers.",
               "bench_fanout");
  app.add_option("--clients", plan.clients, "subscribers (1000)")->check(CLI::Range(1, 19000));
  app.add_option("--rate", plan.rate, "bursts a second (30)")->check(CLI::Range(0.1, 1000.0));
  app.add_option("--burst", plan.burst, "messages at once (1)")->check(CLI::Range(1, 256));
  app.add_option("--seconds", plan.seconds, "measured in each round (5)")
      ->check(CLI::Range(1, 3600));
  app.add_option("--rounds", plan.rounds, "of which the median counts (5)")
      ->check(CLI::Range(1, 100));
  app.add_option("--against", plan.against,
                 "servers to compare with: redis mosquitto nats (the first two)");
  app.add_flag("--alone", alone, "compare with none");
  app.add_flag("--from-said", plan.from_said,
               "latency of the others from when their publisher said a message, not from its time");
  app.add_flag("--pin", pin, "the server on one processor, everything else on another");
  app.add_flag("--web", plan.web, "ours once more, with a crowd that comes by WebSocket (--web)");
  app.add_option(
         "--trees", plan.trees,
         "ours once more with so many edges behind it, which the crowd is spread over, such as "
         "1,2,4,8; and NATS likewise if it is compared with")
      ->delimiter(',')
      ->check(CLI::Range(1, 64));
  app.add_flag("--one-port", plan.one_port,
               "the edges of --trees have one port together (--reuse-port), not one each");
  app.add_option("--flood", plan.flood,
                 "ours once more, with so many hostile connections at a time, and at --http (0)")
      ->check(CLI::Range(0, 1000));
  auto parsed = aucast::parse_command_line(app, {argv + 1, argv + argc});
  help = app.get_help_ptr()->count() > 0;
  if (help) std::fputs(app.help().c_str(), stdout);
  if (!parsed && !help) return parsed.error();
  if (alone) plan.against.clear();
  if (pin) {
    const auto processors = usable_processors();
    if (processors.size() < 2)
      return aucast::Error{aucast::ErrorKind::Failed, "--pin needs two processors"};
    plan.server_processor = processors[0];
    plan.crowd_processor = processors[1];
  }
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

/// What is measured in each round.
struct Contender {
  std::string name;
  std::string server;
  Plan plan;
};

std::string tree_name(const std::string& server, int edges) {
  return server + " +" + std::to_string(edges);
}

bool compares_with_nats(const Plan& plan) {
  return std::find(plan.against.begin(), plan.against.end(), kNats) != plan.against.end();
}

std::vector<Contender> contenders(const Plan& plan) {
  Plan in_peace = plan;
  in_peace.flood = 0;
  in_peace.web = false;
  Plan flooded = plan;
  flooded.web = false;
  Plan by_web_socket = in_peace;
  by_web_socket.web = true;
  std::vector<Contender> all{{kOurs, kOurs, in_peace}};
  if (plan.flood > 0) all.push_back({kFlooded, kOurs, flooded});
  if (plan.web) all.push_back({kWeb, kOurs, by_web_socket});
  for (const std::string& server : plan.against) all.push_back({server, server, in_peace});
  for (const int edges : plan.trees) {
    Plan tree = in_peace;
    tree.edges = edges;
    all.push_back({tree_name(kOurs, edges), kOurs, tree});
    if (compares_with_nats(plan)) all.push_back({tree_name(kNats, edges), kNats, tree});
  }
  return all;
}

void print(int round, const std::string& name, const Measurement& m, int seconds) {
  std::printf("%5d  %-15s %9.0f %10.0f %8.2f %8.2f %9.2f %7.1f %7lld %6d %6.2f\n", round,
              name.c_str(), m.deliveries, m.per_processor_second(), m.p50_ms, m.p99_ms,
              m.arrived_p99_ms, m.bytes_per_client / 1024, static_cast<long long>(m.missed),
              m.disturbed, load_average());
  if (m.root_seconds > 0) {
    std::printf(
        "       added by the edges: p50 %.2f ms, p99 %.2f ms; the root took %.1f %% of the\n"
        "       processor time; an edge has %.1f MiB without clients\n",
        m.added_p50_ms, m.added_p99_ms, 100 * m.root_seconds / m.processor_seconds,
        m.bytes_per_edge / (1024 * 1024));
  }
  if (m.flood_peers > 0) {
    std::printf(
        "       meanwhile, a second: %lld hostile peers, and %lld at --http, said %lld bytes\n",
        static_cast<long long>(m.flood_peers / seconds),
        static_cast<long long>(m.http_flood_peers / seconds),
        static_cast<long long>(m.flood_bytes / seconds));
  }
  std::fflush(stdout);
}

/// The median over the rounds of one / other, as each round had them one after the other.
void print_ratios(const std::string& one_name, const std::vector<Measurement>& one,
                  const std::string& other_name, const std::vector<Measurement>& other) {
  std::vector<double> deliveries;
  std::vector<double> latency;
  for (std::size_t round = 0; round < one.size(); ++round) {
    deliveries.push_back(one[round].per_processor_second() / other[round].per_processor_second());
    latency.push_back(one[round].p99_ms / other[round].p99_ms);
  }
  std::printf("%s to %s, median of %zu: deliveries per CPU second x %.2f, p99 x %.2f\n",
              one_name.c_str(), other_name.c_str(), one.size(), median(deliveries),
              median(latency));
}

int run(const Plan& plan) {
  const std::vector<Contender> all = contenders(plan);
  std::map<std::string, std::vector<Measurement>> measured;
  int disturbed = 0;
  const OnProcessor placed(plan.crowd_processor);
  std::printf("%d subscribers, %d messages at once every %d ms, %d s a round\n", plan.clients,
              plan.burst, plan.period_ms(), plan.seconds);
  std::printf(
      "round  server         deliveries per CPU s   p50 ms   p99 ms   arrived KiB/cl.  missed"
      "   lost   load\n");
  for (int round = 1; round <= plan.rounds; ++round) {
    for (const Contender& contender : all) {
      std::string failure;
      const auto measurement = aucast::bench::measure(contender.server, contender.plan, failure);
      if (!measurement) {
        std::fprintf(stderr, "bench_fanout: %s: %s\n", contender.name.c_str(), failure.c_str());
        return 1;
      }
      print(round, contender.name, *measurement, plan.seconds);
      measured[contender.name].push_back(*measurement);
      if (contender.server == kOurs) disturbed += measurement->disturbed;
    }
  }
  if (plan.flood > 0) print_ratios(kFlooded, measured[kFlooded], kOurs, measured[kOurs]);
  if (plan.web) print_ratios(kWeb, measured[kWeb], kOurs, measured[kOurs]);
  for (const std::string& server : plan.against) {
    print_ratios(kOurs, measured[kOurs], server, measured[server]);
  }
  for (const int edges : plan.trees) {
    const std::string tree = tree_name(kOurs, edges);
    print_ratios(tree, measured[tree], kOurs, measured[kOurs]);
    if (!compares_with_nats(plan)) continue;
    const std::string other = tree_name(kNats, edges);
    print_ratios(tree, measured[tree], other, measured[other]);
  }
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
