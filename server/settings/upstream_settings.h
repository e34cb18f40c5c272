#pragma once

#include <filesystem>

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

}  // namespace aucast::server
