#pragma once

#include <string>

#include "common/result.h"
#include "server/settings/transmitter_options.h"

namespace aucast::server {

/// Checks the addresses of --push, the secrets for them and the publishers of --accept-push.
/// Returns the line that --check prints about the publishers; empty: there are none. Errors are
/// those of dialled_address() and load_credentials().
[[nodiscard]] Result<std::string> check_pushes(const TransmitterOptions& options);

}  // namespace aucast::server
