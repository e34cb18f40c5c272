#pragma once

#include <filesystem>

#include "common/tls/context.h"

namespace aucast::server {

/// Where the secrets are: files that the operator may replace while the transmitter runs.
struct CredentialFiles {
  tls::Files tls;                    ///< no certificate: plain connections
  tls::Files web;                    ///< of --web, likewise
  std::filesystem::path token;       ///< empty: none is needed
  std::filesystem::path publishers;  ///< who may bring streams; empty: nobody
  friend bool operator==(const CredentialFiles&, const CredentialFiles&) = default;
};

}  // namespace aucast::server
