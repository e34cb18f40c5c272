#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/tls/context.h"

namespace aucast::server {

/// To which servers this one's streams are pushed (--push), and how.
struct PushSettings {
  std::vector<std::string> addresses;  ///< aucast://HOST[/NAME], each with its own connection
  std::filesystem::path token;         ///< file of the token to show there; empty: none
  tls::Files tls;                      ///< the authorities to trust for aucasts:// addresses
  friend bool operator==(const PushSettings&, const PushSettings&) = default;
};

}  // namespace aucast::server
