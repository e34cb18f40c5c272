#pragma once

#include <string>

#include "common/result.h"
#include "server/settings/upstream_settings.h"
#include "server/upstream/upstream.h"

namespace aucast::server {

/// How the stream at `address` is received; `id` and `classic_min` are left to the caller. Reads
/// the files and warns in the log of secrets that others can read. Usage error when the token would
/// go over the network for everybody to read.
[[nodiscard]] Result<UpstreamOptions> upstream_options(const std::string& address,
                                                       const UpstreamSettings& settings);

}  // namespace aucast::server
