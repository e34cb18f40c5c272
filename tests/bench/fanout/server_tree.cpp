#include "tests/bench/fanout/server_tree.h"

namespace aucast::bench {

ServerTree::ServerTree(const std::string& name, const Plan& plan) : root_(name, plan) {
  for (int edge = 0; edge < plan.edges && failure().empty(); ++edge) {
    Plan its_own = plan;
    if (plan.one_port && !edges_.empty()) its_own.port = edges_.front()->port();
    edges_.push_back(std::make_unique<ServerUnderTest>(name, its_own, &root_));
  }
}

std::string ServerTree::failure() const {
  std::string all = root_.failure();
  for (const auto& edge : edges_) all += edge->failure();
  return all;
}

bool ServerTree::gather(Crowd& crowd, int count) const {
  if (edges_.empty()) return crowd.join(count, root_.port());
  auto left = static_cast<int>(edges_.size());
  for (const auto& edge : edges_) {
    const int part = count / left--;
    if (!crowd.join(part, edge->port())) return false;
    count -= part;
  }
  return true;
}

std::chrono::nanoseconds ServerTree::processor_time() const {
  auto time = root_.processor_time();
  for (const auto& edge : edges_) time += edge->processor_time();
  return time;
}

long ServerTree::private_bytes() const {
  long bytes = root_.private_bytes();
  for (const auto& edge : edges_) bytes += edge->private_bytes();
  return bytes;
}

}  // namespace aucast::bench
