#include "tests/support/fault_proxy.h"

#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <list>
#include <vector>

#include "tests/support/loopback.h"
#include "tests/support/seeded.h"

namespace aucast::test {
namespace {

using Clock = std::chrono::steady_clock;

/// What may be on its way; more is not read, as by a link whose queue is full.
constexpr std::size_t kHeldBytesMax = 65536;

struct Portion {
  Clock::time_point due;
  std::string bytes;
};

/// One direction of one connection.
struct Direction {
  int from = -1;
  int to = -1;
  std::deque<Portion> held;
  std::size_t held_bytes = 0;
  Clock::time_point sent_until;  ///< when the link has passed on all that it got
  bool ended = false;            ///< nothing more comes
  bool closed = false;           ///< and the other side was told
};

struct Connection {
  int client = -1;
  int server = -1;
  Clock::time_point reaches_server;  ///< that it was opened
  std::array<Direction, 2> ways;
};

void read_some(Direction& way, const LinkQuality& quality, Seeded& seeded) {
  std::array<char, 1460> chunk{};
  const ssize_t got = ::recv(way.from, chunk.data(), chunk.size(), MSG_DONTWAIT);
  if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (got <= 0) {
    way.ended = true;
    return;
  }
  way.sent_until = std::max(way.sent_until, Clock::now());
  if (quality.kilobits > 0)
    way.sent_until += std::chrono::microseconds(got * 8000 / quality.kilobits);
  const auto jitter = static_cast<int>(quality.jitter.count());
  auto due =
      way.sent_until + quality.delay + std::chrono::milliseconds(seeded.integer(-jitter, jitter));
  if (!way.held.empty()) due = std::max(due, way.held.back().due);
  way.held.push_back({due, std::string(chunk.data(), static_cast<std::size_t>(got))});
  way.held_bytes += static_cast<std::size_t>(got);
}

/// Hands on what is due; says how many bytes.
std::int64_t write_some(Direction& way) {
  std::int64_t written = 0;
  while (!way.held.empty() && way.held.front().due <= Clock::now()) {
    std::string& bytes = way.held.front().bytes;
    const ssize_t sent = ::send(way.to, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EAGAIN || errno == EINTR)) break;
    if (sent < 0) {
      way.held.clear();
      way.ended = true;
      break;
    }
    written += sent;
    way.held_bytes -= static_cast<std::size_t>(sent);
    bytes.erase(0, static_cast<std::size_t>(sent));
    if (!bytes.empty()) break;
    way.held.pop_front();
  }
  if (way.ended && way.held.empty() && !way.closed) {
    ::shutdown(way.to, SHUT_WR);
    way.closed = true;
  }
  return written;
}

void keep_small_portions(int socket) {
  const int on = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

Connection accept_one(int listener, const LinkQuality& quality) {
  Connection connection;
  connection.client = ::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
  keep_small_portions(connection.client);
  connection.reaches_server = Clock::now() + quality.delay + quality.jitter;
  connection.ways[0].from = connection.ways[1].to = connection.client;
  return connection;
}

void close_both(const Connection& connection) {
  ::close(connection.client);
  if (connection.server >= 0) ::close(connection.server);
}

/// The server hears of the connection as late as of the first bytes over it.
void reach_server(Connection& connection, std::uint16_t port) {
  connection.server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  keep_small_portions(connection.server);
  sockaddr_in address = loopback(port);
  if (::connect(connection.server, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    ::shutdown(connection.client, SHUT_RDWR);
  }
  connection.ways[0].to = connection.ways[1].from = connection.server;
}

}  // namespace

FaultProxy::FaultProxy(const std::string& server, LinkQuality quality, std::uint64_t seed) {
  const LoopbackSocket listener = listen_on_loopback();
  listener_ = listener.descriptor;
  address_ = listener.address();
  const std::uint16_t port = port_of(server);
  thread_ = std::thread([this, port, quality, seed] { run(port, quality, seed); });
}

FaultProxy::~FaultProxy() {
  stop_ = true;
  thread_.join();
  ::close(listener_);
}

void FaultProxy::run(std::uint16_t server_port, LinkQuality quality, std::uint64_t seed) {
  Seeded seeded(seed);
  std::list<Connection> connections;
  while (!stop_) {
    std::vector<pollfd> polled{{down_ ? -1 : listener_, POLLIN, 0}};
    for (const Connection& connection : connections) {
      for (const Direction& way : connection.ways) {
        const bool open = way.from >= 0 && !way.ended && !down_ && way.held_bytes < kHeldBytesMax;
        polled.push_back({open ? way.from : -1, POLLIN, 0});
      }
    }
    ::poll(polled.data(), polled.size(), 1);
    std::size_t index = 1;
    for (Connection& connection : connections) {
      const bool due = Clock::now() >= connection.reaches_server && !down_;
      if (connection.server < 0 && due) reach_server(connection, server_port);
      for (Direction& way : connection.ways) {
        if (polled[index++].revents != 0) read_some(way, quality, seeded);
        if (down_ || connection.server < 0) continue;
        const std::int64_t written = write_some(way);
        if (way.to == connection.client) bytes_to_clients_ += written;
      }
    }
    connections.remove_if([](const Connection& connection) {
      if (!connection.ways[0].closed || !connection.ways[1].closed) return false;
      close_both(connection);
      return true;
    });
    if (polled[0].revents != 0) {
      connections.push_back(accept_one(listener_, quality));
    }
  }
  for (const Connection& connection : connections) close_both(connection);
}

}  // namespace aucast::test
