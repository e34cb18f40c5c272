#pragma once

#include <chrono>

#include "client/net/remote_source.h"
#include "common/link/dialler.h"
#include "protocol/connection_limits.h"

namespace aucast::net {

/// How to dial a server, whether for a stream or for the list of its streams. `attempt` counts
/// from 0; attempts go round `options.host` and all of `options.others`.
[[nodiscard]] inline link::DialOptions dial_options(const RemoteOptions& options,
                                                    std::size_t attempt = 0) {
  const Security& security = options.security;
  link::DialOptions dial;
  dial.host = options.host;
  dial.port = options.port;
  if (const std::size_t host = attempt % (options.others.size() + 1); host > 0) {
    dial.host = options.others[host - 1].host;
    dial.port = options.others[host - 1].port;
  }
  dial.time_max = std::chrono::ceil<Milliseconds>(options.connect_timeout);
  dial.tls = security.tls;
  dial.secret = !security.token.empty() && !security.insecure_token;
  dial.limits = protocol::kLinkLimits;
  dial.limits.drain_time = protocol::kFarewellTimeMax;
  return dial;
}

}  // namespace aucast::net
