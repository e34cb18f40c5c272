#pragma once

#include <string>

#include "common/result.h"
#include "protocol/endpoint.h"
#include "server/settings/engine_settings.h"

namespace aucast::server {

/// Where servers of NATS are and what is shown to them.
struct NatsOptions {
  protocol::StreamAddress address;
  std::string token;  ///< empty: none
  std::string user;   ///< empty: none
  std::string password;
  EngineSettings settings;
};

/// Reads the address, the token's file and that of the login, and looks whether the others can be
/// read. Usage, unreadable or bad data.
[[nodiscard]] Result<NatsOptions> nats_options(const std::string& address,
                                               const EngineSettings& settings);

}  // namespace aucast::server
