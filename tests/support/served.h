#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/support/process.h"

namespace aucast::test {

/// The real au-transmitter, serving on a free port of this host for as long as the object lives.
class Served {
 public:
  /// `arguments`: sources and options beside --port 0; `variables` of the environment as
  /// NAME=VALUE.
  explicit Served(std::vector<std::string> arguments, std::vector<std::string> variables = {});

  /// HOST:PORT, empty when it did not get ready (see process().err()).
  [[nodiscard]] const std::string& address() const { return address_; }
  [[nodiscard]] Process& process() { return *process_; }

 private:
  std::unique_ptr<Process> process_;
  std::string address_;
};

/// A stream file that the project ships, such as six_expressions.txt.
[[nodiscard]] std::string stream_file(const std::string& name);

}  // namespace aucast::test
