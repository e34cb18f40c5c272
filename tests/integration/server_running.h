#pragma once

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/eventually.h"
#include "tests/support/process.h"
#include "tests/support/raw_client.h"
#include "tests/support/served.h"

namespace aucast::test {

[[nodiscard]] inline bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// What six_expressions.txt is on the wire of level 1.
inline const std::vector<std::string> kSixPackets = {"{1,2,5,15,16,20,26}", "{1,2,4,5,15,20,26}",
                                                     "{2,4,9,15,17}",       "{2,4,7,9,10,20,26}",
                                                     "{1,6,12,14}",         "{1,4,15,23}"};
inline const std::string kEnd = "{-2}";

inline std::string joined(const std::vector<std::string>& packets) {
  std::string all;
  for (const std::string& packet : packets) all += packet;
  return all;
}

/// au-transmitter on a free port of the loopback, ready to be connected to.
class RunningTransmitter {
 public:
  explicit RunningTransmitter(std::vector<std::string> arguments,
                              std::vector<std::string> variables = {})
      : served_(std::move(arguments), std::move(variables)) {
    EXPECT_FALSE(address().empty()) << log();
  }

  [[nodiscard]] const std::string& address() const { return served_.address(); }
  [[nodiscard]] std::string port() const { return address().substr(address().rfind(':') + 1); }
  [[nodiscard]] RawClient connect() const { return RawClient(address()); }
  [[nodiscard]] Process& process() { return served_.process(); }

  /// Sends SIGTERM and returns the exit code; nullopt when the server does not end.
  std::optional<int> terminate() {
    process().signal(SIGTERM);
    return process().wait(kPatience);
  }
  /// The log; complete after terminate().
  [[nodiscard]] const std::string& log() { return process().err(); }

 private:
  Served served_;
};

/// Connects and says hello. Tries again until the hello arrives within the server's grace, since a
/// loaded machine may hold a test up for longer. `reply` is the server's first packet.
inline RawClient say_hello(const RunningTransmitter& server, std::string_view hello,
                           std::string& reply) {
  for (int attempt = 1;; ++attempt) {
    RawClient client = server.connect();
    client.send(hello);
    reply = client.receive_until("}");
    const bool in_time = reply.starts_with("{hello") || reply.starts_with("{error");
    if (in_time || attempt == 20) return client;
  }
}

/// Reads the log until `text` is in it `times` times. Returns whether it is.
inline bool logs(Process& process, const std::string& text, int times = 1) {
  const auto count = [&] {
    int found = 0;
    for (std::size_t at = process.err().find(text); at != std::string::npos;
         at = process.err().find(text, at + 1)) {
      ++found;
    }
    return found;
  };
  static_cast<void>(eventually(
      [&] { return count() >= times || process.wait(std::chrono::milliseconds(10)).has_value(); }));
  return count() >= times;
}

inline bool logs(RunningTransmitter& server, const std::string& text, int times = 1) {
  return logs(server.process(), text, times);
}

/// Receives the stream as a classic client that answers each packet; it must be the six
/// expressions.
inline void expect_six_packets(RawClient& client) {
  ASSERT_TRUE(client.ok());
  for (const std::string& packet : kSixPackets) {
    ASSERT_EQ(client.receive(packet.size()), packet);
    ASSERT_TRUE(client.send("1"));
  }
  EXPECT_EQ(client.receive_all(), kEnd);
  EXPECT_FALSE(client.broken());
}

}  // namespace aucast::test
