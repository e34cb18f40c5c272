#include "server/upstream/dialled_address.h"

#include <utility>

#include "common/link/host.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/token_file.h"

namespace aucast::server {

Result<DialledAddress> dialled_address(const std::string& address, const DialSecrets& secrets) {
  auto parsed = protocol::parse_stream_address(address);
  if (!parsed) return parsed.error();
  DialledAddress dialled;
  dialled.address = *std::move(parsed);
  if (dialled.address.tls) {
    auto context = tls::Context::for_client(secrets.tls, secrets.tls_options);
    if (!context) return context.error();
    if (!context->warning().empty()) spdlog::warn("{}", context->warning());
    dialled.tls = *std::move(context);
  }
  if (secrets.token.empty()) return dialled;
  auto token = protocol::read_token_file(secrets.token);
  if (!token) return token.error();
  if (!token->warning.empty()) spdlog::warn("{}", token->warning);
  dialled.token = std::move(token->word);
  for (const protocol::Endpoint& host : dialled.address.hosts) {
    if (dialled.tls || link::is_own_host(host.host)) continue;
    return Error{ErrorKind::Usage, "everybody on the way to " + escaped(host.host) +
                                       " could read the token: use aucasts:// (try --help)"};
  }
  return dialled;
}

}  // namespace aucast::server
