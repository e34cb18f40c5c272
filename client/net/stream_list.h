#pragma once

#include <string>
#include <vector>

#include "client/net/remote_source.h"
#include "common/result.h"

namespace aucast::net {

/// Asks a server for the names of its streams, in its order; a client that names none gets the
/// first. Blocks until they have come, at most options.connect_timeout. Network error otherwise,
/// naming the server and the cause. Only the options about the connection are used.
[[nodiscard]] Result<std::vector<std::string>> list_streams(const RemoteOptions& options);

}  // namespace aucast::net
