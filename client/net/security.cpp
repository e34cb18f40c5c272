#include "client/net/security.h"

#include <utility>

#include "common/own_computer.h"
#include "common/text.h"
#include "protocol/token_file.h"

namespace aucast::net {

Result<Security> load_security(const SecurityOptions& options, std::string_view host) {
  Security security;
  security.insecure_token = options.insecure_token;
  if (options.tls || options.files != tls::Files{}) {
    auto context = tls::Context::for_client(options.files);
    if (!context) return context.error();
    security.warning = context->warning();
    security.tls = std::move(*context);
  }
  if (options.token.empty()) return security;
  auto token = protocol::read_token_file(options.token);
  if (!token) return token.error();
  security.token = std::move(token->word);
  if (!token->warning.empty()) {
    security.warning += (security.warning.empty() ? "" : "; ") + token->warning;
  }
  if (!security.tls && !options.insecure_token && !host.empty() && !is_own_computer(host)) {
    return Error{ErrorKind::Usage,
                 "everybody on the way to " + escaped(host) +
                     " could read the token: add --tls, or --insecure-token to show it all the "
                     "same"};
  }
  return security;
}

}  // namespace aucast::net
