#include "server/upstream/dialled_address.h"

#include <utility>

#include "common/log.h"
#include "common/options.h"
#include "common/own_computer.h"
#include "common/text.h"
#include "protocol/token_file.h"

namespace aucast::server {

Result<void> check_hidden(const protocol::StreamAddress& address, std::string_view what,
                          std::string_view secure) {
  for (const protocol::Endpoint& host : address.hosts) {
    if (address.tls || is_own_computer(host.host)) continue;
    return usage_error("everybody on the way to " + escaped(host.host) + " could read " +
                       std::string(what) + ": use " + std::string(secure));
  }
  return {};
}

Result<std::string> token_for(const protocol::StreamAddress& address,
                              const std::filesystem::path& file, std::string_view secure) {
  if (file.empty()) return std::string();
  auto token = protocol::read_token_file(file);
  if (!token) return token.error();
  if (!token->warning.empty()) spdlog::warn("{}", token->warning);
  if (auto hidden = check_hidden(address, "the token", secure); !hidden) return hidden.error();
  return std::move(token->word);
}

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
  auto token = token_for(dialled.address, secrets.token, "aucasts://");
  if (!token) return token.error();
  dialled.token = *std::move(token);
  return dialled;
}

}  // namespace aucast::server
