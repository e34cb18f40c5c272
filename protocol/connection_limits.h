#pragma once

#include "common/link_limits.h"
#include "protocol/limits.h"

namespace aucast::protocol {

/// The limits of every connection of both programs.
inline constexpr link::Limits kLinkLimits{
    kTlsHandshakeTimeMax, kDrainTimeMax,      kDrainBytesMax,   kOutputBytesMax,
    kKeepAliveIdle,       kKeepAliveInterval, kKeepAliveProbes, kUnansweredTimeMax,
    kWebFrameBytesMax,    kWebPingIdle,       kWebPongTimeMax};

static_assert(link::kReadBytes == kReadBytesMax);

}  // namespace aucast::protocol
