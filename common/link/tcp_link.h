#pragma once

#include <memory>

#include <asio/ip/tcp.hpp>

#include "common/link/link.h"
#include "common/link_limits.h"

namespace aucast::link {

/// A link over a connected socket, without TLS. `held_back_max`: how many unsent bytes the system
/// may hold before the link counts as blocked, for streams of which only the newest data matters;
/// 0: as many as the system likes.
[[nodiscard]] std::shared_ptr<Link> tcp_link(asio::ip::tcp::socket socket, const Limits& limits,
                                             int held_back_max = 0);

}  // namespace aucast::link
