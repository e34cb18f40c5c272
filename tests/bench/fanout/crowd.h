#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/fanout/plan.h"
#include "tests/bench/fanout/server_under_test.h"
#include "tests/bench/fanout/web_side.h"

namespace aucast::bench {

/// A message that arrived at one subscriber.
struct Delivery {
  std::size_t subscriber = 0;
  std::int64_t number = 0;
  Clock::time_point arrived;  ///< when the system had received it for the subscriber
  Clock::time_point read;     ///< when the subscriber had read it
};

/// Many subscribers on one thread and one epoll. Each must get every message from its first on, in
/// order; what it does not get is counted.
class Crowd {
 public:
  explicit Crowd(const Dialect& dialect);
  ~Crowd();
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  /// Connects `count` more subscribers to a port and sends their greetings. Returns false and sets
  /// failure() when that fails.
  bool join(int count, std::uint16_t port);
  /// Receives until `until`. Appends what comes to `deliveries` unless that is null.
  void listen(Clock::time_point until, std::vector<Delivery>* deliveries);
  /// Receives until all have been welcomed. Returns false when that takes more than `patience`.
  bool wait_for_welcome(Clock::duration patience);

  [[nodiscard]] const std::string& failure() const { return failure_; }
  /// Messages that were left out for a subscriber, or came twice or out of order.
  [[nodiscard]] std::int64_t missed() const { return missed_; }
  /// Subscribers whose connection ended or who got something that is no message.
  [[nodiscard]] int disturbed() const { return disturbed_; }

 private:
  struct Subscriber {
    std::size_t index = 0;
    int socket = -1;
    bool welcomed = false;
    std::int64_t expected = -1;
    std::string held;  ///< an incomplete message
    WebSide web;       ///< if the dialect is of WebSocket
  };

  void receive(Subscriber& subscriber, std::vector<Delivery>* deliveries);
  [[nodiscard]] ssize_t read(int socket, Clock::time_point& arrived);
  [[nodiscard]] bool take_frames(Subscriber& subscriber, std::string_view wire, std::string& text);
  [[nodiscard]] std::size_t take_welcome(Subscriber& subscriber, std::string_view bytes);
  void take_message(Subscriber& subscriber, std::int64_t number);
  void disturb(Subscriber& subscriber, const std::string& how);

  Dialect dialect_;
  int epoll_ = -1;
  std::vector<Subscriber> subscribers_;
  std::vector<char> input_;
  std::chrono::nanoseconds real_ahead_{};  ///< by how much the time of day is ahead of our clock
  int welcomed_ = 0;
  int disturbed_ = 0;
  std::int64_t missed_ = 0;
  std::string failure_;
};

/// Connects to the loopback by TCP from one of several source addresses, so that ports do not run
/// short. Returns a non-blocking socket; -1 when it fails.
[[nodiscard]] int connect_to(std::uint16_t port, int number);

}  // namespace aucast::bench
