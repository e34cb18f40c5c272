#include "tests/support/relay.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

#include "tests/support/loopback.h"
#include "tests/support/seeded.h"

namespace aucast::test {
namespace {

/// One direction: what was read and not yet handed on.
struct RelayedWay {
  int from = -1;
  int to = -1;
  std::string held;
  bool ended = false;   ///< the reading side is through
  bool closed = false;  ///< and the writing side was told
};

void read_some(RelayedWay& direction) {
  std::array<char, 4096> chunk{};
  const ssize_t got = ::recv(direction.from, chunk.data(), chunk.size(), 0);
  if (got > 0) direction.held.append(chunk.data(), static_cast<std::size_t>(got));
  if (got <= 0) direction.ended = true;
}

/// Hands on a random portion, often a single byte, sometimes everything.
void write_some(RelayedWay& direction, Seeded& seeded) {
  if (!direction.held.empty() && seeded.chance(0.6)) {
    const int all = static_cast<int>(direction.held.size());
    const int portion = seeded.chance(0.3) ? all : seeded.integer(1, all);
    const auto size = static_cast<std::size_t>(portion);
    if (::send(direction.to, direction.held.data(), size, MSG_NOSIGNAL) < 0) direction.ended = true;
    direction.held.erase(0, size);
  }
  if (direction.ended && direction.held.empty() && !direction.closed) {
    ::shutdown(direction.to, SHUT_WR);
    direction.closed = true;
  }
}

void relay(int client, int server, Seeded& seeded, const std::atomic<bool>& stop) {
  std::array<RelayedWay, 2> directions{{{client, server, {}}, {server, client, {}}}};
  while (!stop && !(directions[0].closed && directions[1].closed)) {
    std::array<pollfd, 2> polled{};
    for (std::size_t i = 0; i < 2; ++i) {
      polled[i] = {directions[i].ended ? -1 : directions[i].from, POLLIN, 0};
    }
    ::poll(polled.data(), polled.size(), seeded.integer(0, 3));
    for (std::size_t i = 0; i < 2; ++i) {
      if (polled[i].revents != 0) read_some(directions[i]);
      write_some(directions[i], seeded);
    }
  }
}

}  // namespace

Relay::Relay(const std::string& server, std::uint64_t seed) {
  const LoopbackSocket listener = listen_on_loopback();
  listener_ = listener.descriptor;
  address_ = listener.address();
  const std::uint16_t port = port_of(server);
  thread_ = std::thread([this, port, seed] { run(port, seed); });
}

Relay::~Relay() {
  stop_ = true;
  thread_.join();
  ::close(listener_);
}

void Relay::run(std::uint16_t server_port, std::uint64_t seed) {
  Seeded seeded(seed);
  while (!stop_) {
    pollfd waiting{listener_, POLLIN, 0};
    if (::poll(&waiting, 1, 20) <= 0) continue;
    const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(server_port);
    if (::connect(server, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
      relay(client, server, seeded, stop_);
    }
    ::close(client);
    ::close(server);
  }
}

}  // namespace aucast::test
