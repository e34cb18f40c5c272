#include "server/engine/nats_options.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "common/files.h"
#include "common/log.h"
#include "common/options.h"
#include "common/text.h"
#include "common/text_file.h"
#include "server/upstream/dialled_address.h"

namespace aucast::server {
namespace {

/// The client library would take revocation lists and let everybody in all the same.
Result<void> check_authorities(const std::filesystem::path& path) {
  if (path.empty()) return {};
  const auto file = read_file(path);
  if (!file) return file.error();
  if (file->find("-----BEGIN X509 CRL-----") == std::string::npos) return {};
  return Error{ErrorKind::BadData,
               at_place(path.string(),
                        "has revocation lists, which NATS' library does not heed; name a file "
                        "without them (--nats-tls-ca)")};
}

/// For files that the client library reads itself: its message about a missing one names no file.
Result<void> check_readable(const EngineSettings& settings) {
  constexpr std::size_t kBytesMax = 65536;
  for (const std::filesystem::path& path :
       {settings.creds, settings.seed, settings.tls.key, settings.tls.certificate}) {
    if (path.empty()) continue;
    const auto file = read_secret_file(path, kBytesMax);
    if (!file) return file.error();
    if (file->open_to_others && path != settings.tls.certificate) {
      spdlog::warn("{}: other users have access to it (chmod 600)", printable(path.string()));
    }
  }
  return check_authorities(settings.tls.authorities);
}

Result<void> check_settings(const EngineSettings& settings) {
  if (settings.nkey.empty() != settings.seed.empty()) {
    return usage_error("--nats-nkey and --nats-seed go together");
  }
  const auto ways = {!settings.token.empty(), !settings.login.empty(), !settings.creds.empty(),
                     !settings.nkey.empty()};
  if (std::count(ways.begin(), ways.end(), true) > 1) {
    return usage_error(
        "--nats-token-file, --nats-login, --nats-creds, --nats-nkey: one of them, not several");
  }
  if (settings.tls.certificate.empty() != settings.tls.key.empty()) {
    return usage_error("--nats-tls-cert and --nats-tls-key go together");
  }
  return {};
}

/// Reads the file's only line, USER:PASSWORD, into `options`; does nothing without a file.
Result<void> read_login(const std::filesystem::path& path, NatsOptions& options) {
  constexpr std::size_t kBytesMost = 1024;
  if (path.empty()) return {};
  const auto file = read_secret_file(path, kBytesMost);
  if (!file) return file.error();
  if (file->open_to_others) {
    spdlog::warn("{}: other users have access to the password (chmod 600)",
                 printable(path.string()));
  }
  const std::string_view line = trimmed(file->bytes, "\r\n");
  const std::size_t colon = line.find(':');
  constexpr std::string_view kNotInALine("\r\n\0", 3);
  if (colon == 0 || colon == std::string_view::npos ||
      line.find_first_of(kNotInALine) != std::string_view::npos) {
    return Error{ErrorKind::BadData,
                 at_place(path.string(), "one line is expected, NAME:PASSWORD")};
  }
  options.user = line.substr(0, colon);
  options.password = line.substr(colon + 1);
  return check_hidden(options.address, "the password", "natss://");
}

}  // namespace

Result<NatsOptions> nats_options(const std::string& address, const EngineSettings& settings) {
  auto parsed = protocol::parse_engine_address(address);
  if (!parsed) return parsed.error();
  if (auto good = check_settings(settings); !good) return good.error();
  if (auto readable = check_readable(settings); !readable) return readable.error();
  NatsOptions options{*std::move(parsed), {}, {}, {}, settings};
  auto token = token_for(options.address, settings.token, "natss://");
  if (!token) return token.error();
  options.token = *std::move(token);
  if (auto login = read_login(settings.login, options); !login) return login.error();
  return options;
}

}  // namespace aucast::server
