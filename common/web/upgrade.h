#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/web/http.h"

namespace aucast::web {

/// Why a request cannot become a WebSocket (RFC 6455, 4.2.1): the reply that says so, with the
/// remedy. Nothing: it can.
[[nodiscard]] std::optional<HttpReply> refuse_upgrade(const HttpRequest& request);

/// The reply to a request that is not refused. No subprotocol and no extension is taken.
[[nodiscard]] std::string accept_upgrade(const HttpRequest& request);

/// What Sec-WebSocket-Accept answers to a Sec-WebSocket-Key.
[[nodiscard]] std::string accept_key(std::string_view key);

}  // namespace aucast::web
