#include "tests/support/served.h"

namespace aucast::test {

Served::Served(std::vector<std::string> arguments, std::vector<std::string> variables) {
  arguments.insert(arguments.begin(), {program("au-transmitter"), "--port", "0"});
  process_ = std::make_unique<Process>(std::move(arguments), std::move(variables));
  const auto line = process_->read_line(std::chrono::seconds(20));
  const std::string ready = "listening on ";
  if (line && line->starts_with(ready)) address_ = line->substr(ready.size());
}

std::string stream_file(const std::string& name) {
  return program("data/streams/" + name);
}

}  // namespace aucast::test
