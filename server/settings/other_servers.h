#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/time.h"
#include "common/tls/context.h"

namespace aucast::server {

/// How streams of other servers are received.
struct UpstreamSettings {
  std::filesystem::path token;  ///< file of the token to show to the parents; empty: none
  tls::Files tls;               ///< the authorities to trust for aucasts:// addresses
  Milliseconds wait{10'000};    ///< how long clients wait while no parent sends
  friend bool operator==(const UpstreamSettings&, const UpstreamSettings&) = default;
};

/// To which servers this one's streams are pushed (--push), and how.
struct PushSettings {
  std::vector<std::string> addresses;  ///< aucast://HOST[/NAME], each with its own connection
  std::filesystem::path token;         ///< file of the token to show there; empty: none
  tls::Files tls;                      ///< the authorities to trust for aucasts:// addresses
  friend bool operator==(const PushSettings&, const PushSettings&) = default;
};

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
