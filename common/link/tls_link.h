#pragma once

#include <memory>
#include <string>

#include "common/link/link.h"
#include "common/link_limits.h"
#include "common/tls/layer.h"

namespace aucast::link {

/// TLS over another link. Opens when the handshake is done, which may take at most
/// `limits.tls_handshake`. After a failure the link still drains, so that the peer gets the alert
/// that explains it. `plain_answer` is sent, unencrypted, to a peer that does not speak TLS or says
/// nothing in time, since such a peer may not know that TLS is needed. Empty: nothing is sent.
[[nodiscard]] std::shared_ptr<Link> tls_link(std::shared_ptr<Link> below, tls::Layer layer,
                                             const Limits& limits, std::string plain_answer = {});

}  // namespace aucast::link
