#pragma once

#include <filesystem>
#include <string>

#include "common/tls/context.h"

namespace aucast::server {

/// What is published over NATS, and our credentials there.
struct EngineSettings {
  std::string publish;          ///< nats://HOST/NAME; empty: nothing is sent there
  std::filesystem::path token;  ///< a word; empty: none
  std::filesystem::path login;  ///< USER:PASSWORD; empty: none
  std::filesystem::path creds;  ///< a user's JWT and seed; empty: none
  std::string nkey;             ///< a public key; empty: none
  std::filesystem::path seed;   ///< of that key
  tls::Files tls;               ///< for natss:// addresses
  friend bool operator==(const EngineSettings&, const EngineSettings&) = default;
};

}  // namespace aucast::server
