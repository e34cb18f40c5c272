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
  bool tls = false;             ///< --tls; also when a file of TLS is named
  tls::Files files;             ///< --tls-cert, --tls-key, --tls-ca
  std::filesystem::path token;  ///< --token-file
  bool insecure_token = false;  ///< --insecure-token: send it even where others can read it
};

/// How connections are protected, and the token for the server. Ready for use.
struct Security {
  std::optional<tls::Context> tls;  ///< nothing: plain
  std::string token;                ///< empty: none
  bool insecure_token = false;
  std::string warning{};  ///< for the log; else empty
};

/// Reads the files. Unreadable or BadData naming the file and the cause; Usage when a token would
/// go to `host` for everybody on the way to read.
[[nodiscard]] Result<Security> load_security(const SecurityOptions& options, std::string_view host);

}  // namespace aucast::net
