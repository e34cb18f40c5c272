#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/web/http.h"

namespace aucast::web {

/// Checks that a request can become a WebSocket (RFC 6455, 4.2.1). Returns nullopt if it can, else
/// the reply that says why not, with the remedy.
[[nodiscard]] std::optional<HttpReply> refuse_upgrade(const HttpRequest& request);

/// The bytes of the reply to a request that is not refused. The reply accepts no subprotocol and no
/// extension.
[[nodiscard]] std::string accept_upgrade(const HttpRequest& request);

/// The value of Sec-WebSocket-Accept for a Sec-WebSocket-Key.
[[nodiscard]] std::string accept_key(std::string_view key);

}  // namespace aucast::web
