#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/result.h"
#include "common/tls/context.h"
#include "protocol/publishers.h"
#include "server/settings/credential_files.h"

namespace aucast::server {

/// The certificates that the server shows; nullopt: no TLS.
struct Certificates {
  std::optional<tls::Context> tcp;  ///< for --port
  std::optional<tls::Context> web;  ///< for --web
};

struct Credentials {
  Certificates certificates;
  std::string token;  ///< empty: none is needed
  /// Who may bring streams; null: nobody.
  std::shared_ptr<const protocol::Publishers> publishers;
};

/// Reads all the files. Warns in the log of a secret to which other users have access, and of a
/// token that is easy to guess. Fails with Unreadable or BadData and a message that names the file
/// and the cause. A publisher's token that is also the viewers' is BadData too.
[[nodiscard]] Result<Credentials> load_credentials(const CredentialFiles& files);

}  // namespace aucast::server
