#pragma once

#include <memory>
#include <string>

#include "common/link/link.h"
#include "common/link_limits.h"

namespace aucast::link {

/// A WebSocket over a link that is open, whose user so far has read the request for it; start()
/// takes that link over, sends `answer`, the reply to the request, and opens. What is written
/// becomes text messages, what comes as text is handed on as bytes. A peer that sends its Close, or
/// ends without one, is reported as lost, for a WebSocket cannot be half-closed. So is one that is
/// silent for limits.ping_idle and then does not answer a Ping: a proxy in between may hold a
/// connection whose other end has vanished, and drop one that is idle.
[[nodiscard]] std::shared_ptr<Link> web_link(std::shared_ptr<Link> below, std::string answer,
                                             const Limits& limits);

}  // namespace aucast::link
