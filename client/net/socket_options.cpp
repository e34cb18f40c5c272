#include "client/net/socket_options.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "protocol/limits.h"

namespace aucast::net {
namespace {

int seconds(std::chrono::milliseconds time) {
  return static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(time).count());
}

}  // namespace

void set_socket_options(asio::ip::tcp::socket& socket) {
  const auto set = [&socket](int level, int option, int value) {
    static_cast<void>(::setsockopt(socket.native_handle(), level, option, &value, sizeof value));
  };
  set(IPPROTO_TCP, TCP_NODELAY, 1);
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, seconds(protocol::kKeepAliveIdle));
  set(IPPROTO_TCP, TCP_KEEPINTVL, seconds(protocol::kKeepAliveInterval));
  set(IPPROTO_TCP, TCP_KEEPCNT, protocol::kKeepAliveProbes);
  set(IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(protocol::kUnansweredTimeMax.count()));
}

Duration round_trip(asio::ip::tcp::socket& socket) {
  tcp_info info{};
  socklen_t length = sizeof info;
  if (::getsockopt(socket.native_handle(), IPPROTO_TCP, TCP_INFO, &info, &length) != 0) return {};
  return std::chrono::microseconds(info.tcpi_rtt);
}

}  // namespace aucast::net
