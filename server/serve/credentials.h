#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "common/result.h"
#include "common/tls/context.h"

namespace aucast::server {

/// Where the secrets are: files that the operator may replace while the transmitter runs.
struct CredentialFiles {
  tls::Files tls;               ///< no certificate: plain connections
  std::filesystem::path token;  ///< empty: none is needed
  friend bool operator==(const CredentialFiles&, const CredentialFiles&) = default;
};

struct Credentials {
  std::optional<tls::Context> tls;  ///< nothing: plain connections
  std::string token;                ///< empty: none is needed
};

/// Reads all of them and warns in the log of a secret that other users have access to and of a
/// token that is easy to guess. Unreadable or BadData naming the file and the cause.
[[nodiscard]] Result<Credentials> load_credentials(const CredentialFiles& files);

}  // namespace aucast::server
