#include "tests/bench/fanout/publisher.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "tests/bench/fanout/crowd.h"
#include "tests/bench/fanout/message.h"

namespace aucast::bench {

Publisher::Publisher(const Plan& plan, const ServerUnderTest& server, std::int64_t messages_max)
    : plan_(plan), said_(static_cast<std::size_t>(messages_max)) {
  thread_ = std::thread([this, &server] { run(server.dialect(), server.port()); });
}

void Publisher::stop() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Publisher::run(const Dialect& dialect, std::uint16_t port) {
  const int socket = connect_to(port, 0);
  ::fcntl(socket, F_SETFL, 0);
  std::array<char, 4096> answers{};
  if (!dialect.announce.empty()) {
    ::send(socket, dialect.announce.data(), dialect.announce.size(), MSG_NOSIGNAL);
    ::recv(socket, answers.data(), dialect.announced_bytes, MSG_WAITALL);
  }
  begin_ = Clock::now();
  const auto count = static_cast<std::int64_t>(said_.size()) / plan_.burst * plan_.burst;
  for (std::int64_t number = 0; number < count && !stop_; number += plan_.burst) {
    std::this_thread::sleep_until(due(number));
    std::string bytes;
    for (int i = 0; i < plan_.burst; ++i) {
      bytes += dialect.wrap(message(number + i, i + 1 == plan_.burst ? plan_.period_ms() : 0));
    }
    // As the others, au-transmitter's burst begins at one moment.
    std::fill_n(said_.begin() + number, plan_.burst, Clock::now());
    if (::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) break;
    while (::recv(socket, answers.data(), answers.size(), MSG_DONTWAIT) > 0) continue;
  }
  ::close(socket);
}

}  // namespace aucast::bench
