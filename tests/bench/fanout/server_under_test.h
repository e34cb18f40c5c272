#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "tests/bench/fanout/plan.h"
#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast::bench {

/// What subscribers and the publisher send to a server, and what it answers.
struct Dialect {
  std::string greeting;           ///< sent once after connecting
  std::size_t welcome_bytes = 0;  ///< length of the answer; 0: see the next two members
  std::string welcome_begin;
  std::string welcome_end;
  std::string announce;             ///< sent by the publisher first
  std::size_t announced_bytes = 0;  ///< length of the answer to `announce`
  /// A message as the publisher sends it; null: the server publishes by itself.
  std::string (*wrap)(const std::string& message) = nullptr;
  bool web = false;  ///< all of this goes over a WebSocket
};

/// One of the servers that are compared, running as a child process on a free port of the loopback.
class ServerUnderTest {
 public:
  /// `name`: au-transmitter, redis, mosquitto or nats. With a `parent`, the server is an edge,
  /// which gets all its messages from the parent (au-transmitter's relay, NATS' leaf node).
  ServerUnderTest(const std::string& name, const Plan& plan,
                  const ServerUnderTest* parent = nullptr);
  ~ServerUnderTest();
  ServerUnderTest(const ServerUnderTest&) = delete;
  ServerUnderTest& operator=(const ServerUnderTest&) = delete;

  /// Empty when the server runs, else why not.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// The port of au-transmitter's --http if that is to be flooded; else 0.
  [[nodiscard]] std::uint16_t http_port() const { return http_port_; }
  [[nodiscard]] const Dialect& dialect() const { return dialect_; }
  /// Processor time of the process so far, in user mode and in the system.
  [[nodiscard]] std::chrono::nanoseconds processor_time() const;
  /// Memory that is the process' own, in bytes.
  [[nodiscard]] long private_bytes() const;
  [[nodiscard]] std::size_t descriptors() const;

 private:
  void start_transmitter(const Plan& plan, const ServerUnderTest* parent);
  [[nodiscard]] std::string numbered_stream(const Plan& plan);
  void start_redis();
  void start_mosquitto();
  void start_nats(const ServerUnderTest* parent);
  void wait_until_it_listens();

  test::TempFolder folder_;
  std::unique_ptr<test::Process> process_;
  std::string failure_;
  std::uint16_t port_ = 0;
  std::uint16_t http_port_ = 0;
  std::uint16_t leaf_port_ = 0;  ///< for leaf nodes of NATS
  Dialect dialect_;
};

}  // namespace aucast::bench
