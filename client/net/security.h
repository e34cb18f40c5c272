#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"
#include "common/tls/context.h"

namespace aucast::net {

/// What the command line says about security.
struct SecurityOptions {
  bool tls = false;             ///< --tls; any file for TLS turns it on too
  tls::Files files;             ///< --tls-cert, --tls-key, --tls-ca
  std::filesystem::path token;  ///< --token-file
  bool insecure_token = false;  ///< --insecure-token: send it even where others can read it
};

/// How connections are protected, and the token for the server, with all files read.
struct Security {
  std::optional<tls::Context> tls;  ///< nullopt: without TLS
  std::string token;                ///< empty: none
  bool insecure_token = false;
  std::string warning{};  ///< for the log; empty: none
};

/// Reads the files. Fails with Unreadable or BadData and a message that names the file and the
/// cause, or with Usage if the token would go over the network to `host` unencrypted and
/// `insecure_token` is not set.
[[nodiscard]] Result<Security> load_security(const SecurityOptions& options, std::string_view host);

}  // namespace aucast::net
