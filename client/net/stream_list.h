#pragma once

#include <string>
#include <vector>

#include "client/net/remote_source.h"
#include "common/result.h"

namespace aucast::net {

/// Asks a server for the names of its streams, in its order; the first is the one that a client
/// gets which names none. Blocks until they are here, at most options.connect_timeout. Network
/// error otherwise, naming the server and the cause. Of the options those of the connection count.
[[nodiscard]] Result<std::vector<std::string>> list_streams(const RemoteOptions& options);

}  // namespace aucast::net
