#include "server/serve/credentials.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "common/log.h"
#include "common/text.h"
#include "protocol/token_file.h"

namespace aucast::server {
namespace {

/// A shorter token can be guessed.
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

/// Warns if some of the `tokens` in the file are short.
void warn_of_short(const std::vector<std::string_view>& tokens, const std::filesystem::path& file) {
  const auto count = static_cast<std::size_t>(std::count_if(
      tokens.begin(), tokens.end(), [](auto token) { return token.size() < kTokenBytesGood; }));
  if (count == 0) return;
  spdlog::warn(
      "{}: {} of fewer than {} characters may be guessed; 'openssl rand -hex 16' makes a good one",
      file.string(), counted(count, "token"), kTokenBytesGood);
}

Result<std::shared_ptr<const protocol::Publishers>> load_publishers(
    const std::filesystem::path& path, const std::string& token_of_viewers) {
  auto file = protocol::read_publisher_file(path);
  if (!file) return file.error();
  if (!file->warning.empty()) spdlog::warn("{}", file->warning);
  std::vector<std::string_view> tokens;
  for (const auto& publisher : file->publishers.all()) {
    if (publisher.token == token_of_viewers) {
      return Error{ErrorKind::BadData, at_place(path.string(),
                                                "the token of --token-file is in it: every viewer "
                                                "could bring streams")};
    }
    tokens.emplace_back(publisher.token);
  }
  warn_of_short(tokens, path);
  return std::make_shared<const protocol::Publishers>(std::move(file->publishers));
}

}  // namespace

Result<Credentials> load_credentials(const CredentialFiles& files) {
  Credentials credentials;
  auto tls = load_context(files.tls, "--tls");
  if (!tls) return tls.error();
  credentials.certificates.tcp = std::move(*tls);
  auto web = load_context(files.web, "--web");
  if (!web) return web.error();
  credentials.certificates.web = std::move(*web);
  if (!files.token.empty()) {
    auto token = protocol::read_token_file(files.token);
    if (!token) return token.error();
    if (!token->warning.empty()) spdlog::warn("{}", token->warning);
    warn_of_short({token->word}, files.token);
    credentials.token = std::move(token->word);
  }
  if (files.publishers.empty()) return credentials;
  auto publishers = load_publishers(files.publishers, credentials.token);
  if (!publishers) return publishers.error();
  credentials.publishers = *std::move(publishers);
  return credentials;
}

}  // namespace aucast::server
