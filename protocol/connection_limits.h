#pragma once

#include "common/link_limits.h"
#include "protocol/limits.h"

namespace aucast::protocol {

/// The limits of every connection of both programs.
inline constexpr link::Limits kLinkLimits{.tls_handshake = kTlsHandshakeTimeMax,
                                          .drain_time = kDrainTimeMax,
                                          .drain_bytes = kDrainBytesMax,
                                          .unsent_bytes = kOutputBytesMax,
                                          .keep_alive_idle = kKeepAliveIdle,
                                          .keep_alive_interval = kKeepAliveInterval,
                                          .keep_alive_probes = kKeepAliveProbes,
                                          .unanswered_time = kUnansweredTimeMax,
                                          .frame_bytes = kWebFrameBytesMax,
                                          .ping_idle = kWebPingIdle,
                                          .pong_time = kWebPongTimeMax};

static_assert(link::kReadBytes == kReadBytesMax);

}  // namespace aucast::protocol
