#pragma once

#include <string>

#include "common/result.h"
#include "protocol/endpoint.h"
#include "server/settings/other_servers.h"

namespace aucast::server {

/// Everything needed to connect to an address of NATS. Token and login have been read from their
/// files. The other files are read by NATS' own library; whether they can be read has been checked.
struct NatsOptions {
  protocol::StreamAddress address;
  std::string token;  ///< empty: none
  std::string user;   ///< empty: none
  std::string password;
  EngineSettings settings;
};

/// Reads the address and the files of token and login, and checks that the other files can be read.
/// Fails with Usage, Unreadable or BadData.
[[nodiscard]] Result<NatsOptions> nats_options(const std::string& address,
                                               const EngineSettings& settings);

}  // namespace aucast::server
