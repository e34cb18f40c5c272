#pragma once

#include <memory>
#include <string>

#include "common/link/link.h"
#include "common/link_limits.h"

namespace aucast::link {

/// A WebSocket over `below`, an open link from which the client's request for a WebSocket was read.
/// start() takes `below` over, sends `answer`, the reply to the request, and opens. What is written
/// becomes text messages; the text that comes is handed on as bytes. A peer that sends its Close,
/// or ends without a Close, is reported as lost, since a WebSocket cannot be half-closed. So is a
/// peer that is silent for limits.ping_idle and then does not answer a Ping: a proxy in between may
/// keep the connection although the other end has vanished. Pings also stop a proxy from dropping
/// an idle connection.
[[nodiscard]] std::shared_ptr<Link> web_link(std::shared_ptr<Link> below, std::string answer,
                                             const Limits& limits);

}  // namespace aucast::link
