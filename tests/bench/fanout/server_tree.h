#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/fanout/crowd.h"
#include "tests/bench/fanout/plan.h"
#include "tests/bench/fanout/server_under_test.h"

namespace aucast::bench {

/// A server and the edges behind it that the plan asks for, each a process of its own.
class ServerTree {
 public:
  /// `name` as for ServerUnderTest.
  ServerTree(const std::string& name, const Plan& plan);

  /// Empty when all of them run, else why not.
  [[nodiscard]] std::string failure() const;
  [[nodiscard]] const ServerUnderTest& root() const { return root_; }
  /// Connects `count` subscribers: in equal parts to the edges, or to the root where there are
  /// none.
  bool gather(Crowd& crowd, int count) const;
  /// Processor time of all servers, in user mode and in the system.
  [[nodiscard]] std::chrono::nanoseconds processor_time() const;
  /// Memory that is the processes' own, in bytes.
  [[nodiscard]] long private_bytes() const;

 private:
  ServerUnderTest root_;
  std::vector<std::unique_ptr<ServerUnderTest>> edges_;
};

}  // namespace aucast::bench
