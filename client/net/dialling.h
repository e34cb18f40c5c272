#pragma once

#include <chrono>

#include "client/net/remote_source.h"
#include "common/link/dialler.h"
#include "protocol/connection_limits.h"

namespace aucast::net {

/// How to dial a server, whether for a stream or for the list of its streams. `turn` is the number
/// of the attempt; attempts go round `options.host` and all of `options.others`.
[[nodiscard]] inline link::DialOptions dial_options(const RemoteOptions& options,
                                                    std::size_t turn = 0) {
  const Security& security = options.security;
  link::DialOptions dial;
  dial.host = options.host;
  dial.port = options.port;
  if (const std::size_t place = turn % (options.others.size() + 1); place > 0) {
    dial.host = options.others[place - 1].host;
    dial.port = options.others[place - 1].port;
  }
  dial.time_max = std::chrono::ceil<Milliseconds>(options.connect_timeout);
  dial.tls = security.tls;
  dial.secret = !security.token.empty() && !security.insecure_token;
  dial.limits = protocol::kLinkLimits;
  dial.limits.drain_time = protocol::kFarewellTimeMax;
  return dial;
}

}  // namespace aucast::net
