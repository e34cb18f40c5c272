#include "server/upstream/upstream_options.h"

#include <utility>

#include "common/link/host.h"
#include "common/log.h"
#include "common/text.h"
#include "protocol/token_file.h"

namespace aucast::server {

Result<UpstreamOptions> upstream_options(const std::string& address,
                                         const UpstreamSettings& settings) {
  auto parsed = protocol::parse_stream_address(address);
  if (!parsed) return parsed.error();
  UpstreamOptions options;
  options.address = *std::move(parsed);
  options.wait = settings.wait;
  if (options.address.tls) {
    auto context = tls::Context::for_client(settings.tls);
    if (!context) return context.error();
    if (!context->warning().empty()) spdlog::warn("{}", context->warning());
    options.tls = *std::move(context);
  }
  if (settings.token.empty()) return options;
  auto token = protocol::read_token_file(settings.token);
  if (!token) return token.error();
  if (!token->warning.empty()) spdlog::warn("{}", token->warning);
  options.token = std::move(token->word);
  for (const protocol::Endpoint& parent : options.address.hosts) {
    if (options.tls || link::is_own_host(parent.host)) continue;
    return Error{ErrorKind::Usage, "everybody on the way to " + escaped(parent.host) +
                                       " could read the token: use aucasts:// (try --help)"};
  }
  return options;
}

}  // namespace aucast::server
