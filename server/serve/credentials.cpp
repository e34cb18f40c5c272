#include "server/serve/credentials.h"

#include <utility>

#include "common/log.h"
#include "protocol/token_file.h"

namespace aucast::server {

Result<Credentials> load_credentials(const CredentialFiles& files) {
  Credentials credentials;
  if (!files.tls.certificate.empty()) {
    auto context = tls::Context::for_server(files.tls);
    if (!context) return context.error();
    credentials.tls = std::move(*context);
  }
  if (!files.token.empty()) {
    auto token = protocol::read_token_file(files.token);
    if (!token) return token.error();
    if (!token->warning.empty()) spdlog::warn("{}", token->warning);
    credentials.token = std::move(token->word);
  }
  return credentials;
}

}  // namespace aucast::server
