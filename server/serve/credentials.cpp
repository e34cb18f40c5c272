#include "server/serve/credentials.h"

#include <utility>

#include "common/log.h"
#include "protocol/token_file.h"

namespace aucast::server {
namespace {

/// A shorter token may be found by trying.
constexpr std::size_t kTokenBytesGood = 16;

Result<std::optional<tls::Context>> load_context(const tls::Files& files,
                                                 const std::string& options) {
  std::optional<tls::Context> none;
  if (files.certificate.empty()) return none;
  auto context = tls::Context::for_server(files, options);
  if (!context) return context.error();
  if (!context->warning().empty()) spdlog::warn("{}", context->warning());
  return std::optional(std::move(*context));
}

}  // namespace

Result<Credentials> load_credentials(const CredentialFiles& files) {
  Credentials credentials;
  auto tls = load_context(files.tls, "--tls");
  if (!tls) return tls.error();
  credentials.tls = std::move(*tls);
  auto web = load_context(files.web, "--web");
  if (!web) return web.error();
  credentials.web = std::move(*web);
  if (!files.token.empty()) {
    auto token = protocol::read_token_file(files.token);
    if (!token) return token.error();
    if (!token->warning.empty()) spdlog::warn("{}", token->warning);
    if (token->word.size() < kTokenBytesGood) {
      spdlog::warn(
          "{}: the token has fewer than {} characters and may be guessed; "
          "'openssl rand -hex 16' makes a good one",
          files.token.string(), kTokenBytesGood);
    }
    credentials.token = std::move(token->word);
  }
  return credentials;
}

}  // namespace aucast::server
