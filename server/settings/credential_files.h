#pragma once

#include <filesystem>

#include "common/tls/context.h"

namespace aucast::server {

/// The files with certificates and tokens, which the operator may replace while the transmitter
/// runs.
struct CredentialFiles {
  tls::Files tls;                    ///< for --port; without a certificate: no TLS
  tls::Files web;                    ///< for --web, likewise
  std::filesystem::path token;       ///< empty: none is needed
  std::filesystem::path publishers;  ///< who may send streams here; empty: nobody
  friend bool operator==(const CredentialFiles&, const CredentialFiles&) = default;
};

}  // namespace aucast::server
