#include "server/serve/push_checks.h"

#include <algorithm>

#include "common/text.h"
#include "server/serve/credentials.h"
#include "server/upstream/dialled_address.h"

namespace aucast::server {

Result<std::string> check_pushes(const TransmitterOptions& options) {
  const PushSettings& push = options.push;
  for (const std::string& address : push.addresses) {
    const auto to = dialled_address(address, {push.token, push.tls, "--push-tls"});
    if (!to) return to.error();
  }
  if (options.credentials.publishers.empty()) return std::string();
  const auto credentials = load_credentials(options.credentials);
  if (!credentials) return credentials.error();
  const auto& all = credentials->publishers->all();
  const auto any = std::count_if(all.begin(), all.end(),
                                 [](const auto& publisher) { return publisher.names.empty(); });
  return at_place(
      options.credentials.publishers.string(),
      counted(all.size(), "publisher") + ", " + std::to_string(any) + " of them for any stream\n");
}

}  // namespace aucast::server
