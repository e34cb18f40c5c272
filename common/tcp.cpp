#include "common/tcp.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <chrono>

namespace aucast {

void find_vanished_peer(int socket, const VanishedAfter& after) {
  const auto set = [socket](int level, int option, int value) {
    static_cast<void>(::setsockopt(socket, level, option, &value, sizeof value));
  };
  const auto seconds = [](Milliseconds time) {
    return static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(time).count());
  };
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, seconds(after.idle));
  set(IPPROTO_TCP, TCP_KEEPINTVL, seconds(after.interval));
  set(IPPROTO_TCP, TCP_KEEPCNT, after.probes);
  set(IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(after.unanswered.count()));
}

Duration round_trip(int socket) {
  tcp_info info{};
  socklen_t length = sizeof info;
  if (::getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &length) != 0) return {};
  return std::chrono::microseconds(info.tcpi_rtt);
}

}  // namespace aucast
