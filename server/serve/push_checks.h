#pragma once

#include <string>

#include "common/result.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// Whether the addresses of --push, the secrets for them and the publishers of --accept-push are
/// right; what --check says of the publishers, one line, or nothing. Errors of dialled_address()
/// and load_credentials().
[[nodiscard]] Result<std::string> check_pushes(const TransmitterOptions& options);

}  // namespace aucast::server
