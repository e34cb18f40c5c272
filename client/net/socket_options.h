#pragma once

#include <asio/ip/tcp.hpp>

#include "common/time.h"

namespace aucast::net {

/// Small packets must not wait for each other, and a peer that is gone must be noticed. A system
/// that refuses one of these still plays.
void set_socket_options(asio::ip::tcp::socket& socket);

/// As the system has measured it while connecting; zero when it does not tell.
[[nodiscard]] Duration round_trip(asio::ip::tcp::socket& socket);

}  // namespace aucast::net
