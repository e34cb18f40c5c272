#include "server/engine/nats_options.h"

#include <filesystem>
#include <utility>

#include "common/files.h"
#include "common/log.h"
#include "common/options.h"
#include "common/text.h"
#include "server/upstream/dialled_address.h"

namespace aucast::server {
namespace {

/// Of files that the client library reads by itself: what it says of a missing one names no file.
Result<void> check_readable(const EngineSettings& settings) {
  constexpr std::size_t kBytesMost = 65536;
  for (const std::filesystem::path& path :
       {settings.creds, settings.seed, settings.tls.key, settings.tls.certificate}) {
    if (path.empty()) continue;
    const auto file = read_secret_file(path, kBytesMost);
    if (!file) return file.error();
    if (file->open_to_others && path != settings.tls.certificate) {
      spdlog::warn("{}: other users have access to it", printable(path.string()));
    }
  }
  if (settings.tls.authorities.empty()) return {};
  const auto file = read_file(settings.tls.authorities);
  return file ? Result<void>() : file.error();
}

Result<void> check_settings(const EngineSettings& settings) {
  if (settings.nkey.empty() != settings.seed.empty()) {
    return usage_error("--nats-nkey and --nats-seed go together");
  }
  if (!settings.creds.empty() && !settings.nkey.empty()) {
    return usage_error("--nats-creds or --nats-nkey, not both");
  }
  if (settings.tls.certificate.empty() != settings.tls.key.empty()) {
    return usage_error("--nats-tls-cert and --nats-tls-key go together");
  }
  return {};
}

}  // namespace

Result<NatsOptions> nats_options(const std::string& address, const EngineSettings& settings) {
  auto parsed = protocol::parse_engine_address(address);
  if (!parsed) return parsed.error();
  if (auto good = check_settings(settings); !good) return good.error();
  if (auto readable = check_readable(settings); !readable) return readable.error();
  NatsOptions options{*std::move(parsed), {}, settings};
  auto token = token_for(options.address, settings.token, "natss://");
  if (!token) return token.error();
  options.token = *std::move(token);
  return options;
}

}  // namespace aucast::server
