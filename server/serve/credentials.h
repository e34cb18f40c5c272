#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/result.h"
#include "common/tls/context.h"
#include "protocol/publishers.h"
#include "server/settings/credential_files.h"

namespace aucast::server {

/// The certificates that a server shows; nullopt: its connections are plain.
struct Certificates {
  std::optional<tls::Context> tcp;  ///< at --port
  std::optional<tls::Context> web;  ///< at --web
};

struct Credentials {
  Certificates certificates;
  std::string token;  ///< empty: none is needed
  /// Who may bring streams; null: nobody.
  std::shared_ptr<const protocol::Publishers> publishers;
};

/// Reads all of them and warns in the log of a secret that other users have access to and of a
/// token that is easy to guess. Unreadable or BadData naming the file and the cause; the token of
/// viewers is no publisher's.
[[nodiscard]] Result<Credentials> load_credentials(const CredentialFiles& files);

}  // namespace aucast::server
