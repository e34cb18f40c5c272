#include "tests/support/raw_client.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace aucast::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Waits for `events`; false when they do not come in time.
bool wait_for(int socket, short events, steady_clock::time_point until) {
  for (;;) {
    const auto left = std::chrono::ceil<milliseconds>(until - steady_clock::now());
    pollfd entry{socket, events, 0};
    const int ready = ::poll(&entry, 1, static_cast<int>(std::max<long>(0, left.count())));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

int connect_to(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos) return -1;
  std::string host = address.substr(0, colon);
  if (host.starts_with('[')) host = host.substr(1, host.size() - 2);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), address.substr(colon + 1).c_str(), &hints, &found) != 0) {
    return -1;
  }
  const int made = ::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const bool connected = made >= 0 && ::connect(made, found->ai_addr, found->ai_addrlen) == 0;
  ::freeaddrinfo(found);
  if (connected) return made;
  if (made >= 0) ::close(made);
  return -1;
}

}  // namespace

RawClient::RawClient(const std::string& address) : socket_(connect_to(address)) {
  ok_ = socket_ >= 0;
  ended_ = !ok_;
}

RawClient::~RawClient() {
  if (socket_ >= 0) ::close(socket_);
}

RawClient::RawClient(RawClient&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      ok_(std::exchange(other.ok_, false)),
      ended_(std::exchange(other.ended_, true)),
      broken_(other.broken_),
      received_(std::move(other.received_)) {}

std::uint16_t RawClient::local_port() const {
  sockaddr_storage address{};
  socklen_t length = sizeof(address);
  // In both families the port stands in the same place.
  if (::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &length) != 0) return 0;
  return ntohs(reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

bool RawClient::send(std::string_view bytes, milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  while (ok_ && !bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN) {
      // Too slow is no failure of the connection: the caller may go on.
      if (!wait_for(socket_, POLLOUT, until)) return false;
    } else if (errno != EINTR) {
      ok_ = false;
    }
  }
  return ok_;
}

void RawClient::end_sending() {
  ::shutdown(socket_, SHUT_WR);
}

void RawClient::reset() {
  const linger at_once{1, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof(at_once));
  ::close(std::exchange(socket_, -1));
  ok_ = false;
  ended_ = true;
}

bool RawClient::receive_some(steady_clock::time_point until) {
  if (ended_ || !wait_for(socket_, POLLIN, until)) return false;
  std::array<char, 4096> chunk{};
  const ssize_t got = ::recv(socket_, chunk.data(), chunk.size(), 0);
  if (got > 0) {
    received_.append(chunk.data(), static_cast<std::size_t>(got));
    return true;
  }
  ended_ = true;
  broken_ = got < 0;
  return false;
}

std::string RawClient::take(std::size_t count) {
  std::string taken = received_.substr(0, count);
  received_.erase(0, taken.size());
  return taken;
}

std::string RawClient::receive(std::size_t wanted, milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  while (received_.size() < wanted && receive_some(until)) continue;
  return take(wanted);
}

std::string RawClient::receive_until(std::string_view text, milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  std::size_t found = received_.find(text);
  while (found == std::string::npos && receive_some(until)) found = received_.find(text);
  return take(found == std::string::npos ? received_.size() : found + text.size());
}

std::string RawClient::receive_all(milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  while (receive_some(until)) continue;
  return take(received_.size());
}

bool RawClient::wait_for_end(milliseconds patience) {
  const auto until = steady_clock::now() + patience;
  while (receive_some(until)) received_.clear();
  received_.clear();
  return ended_;
}

bool RawClient::silent(milliseconds time) {
  if (!received_.empty()) return false;
  const bool came = receive_some(steady_clock::now() + time);
  return !came && !ended_;
}

}  // namespace aucast::test
