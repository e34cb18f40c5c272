#pragma once

#include <memory>

#include <asio/ip/tcp.hpp>

#include "common/link/link.h"
#include "common/link_limits.h"

namespace aucast::link {

/// The link of a connected socket, plain. `held_back_max`: what the system may hold back unsent
/// before the link counts as blocked, for streams of which only the newest matters; 0: as much as
/// it likes.
[[nodiscard]] std::shared_ptr<Link> tcp_link(asio::ip::tcp::socket socket, const Limits& limits,
                                             int held_back_max = 0);

}  // namespace aucast::link
