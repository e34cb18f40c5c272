#pragma once

#include <string>

#include "common/result.h"
#include "protocol/endpoint.h"
#include "server/settings/engine_settings.h"

namespace aucast::server {

/// What an address of NATS and the settings come to: secrets that are words are read, files that
/// the library reads by itself are only looked for.
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
