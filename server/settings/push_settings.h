#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/tls/context.h"

namespace aucast::server {

/// How a stream is brought to other servers.
struct PushSettings {
  std::vector<std::string> addresses;  ///< aucast://HOST[/NAME], each with its own connection
  std::filesystem::path token;         ///< shown to them; empty: none
  tls::Files tls;                      ///< for addresses aucasts://: authorities
  friend bool operator==(const PushSettings&, const PushSettings&) = default;
};

}  // namespace aucast::server
