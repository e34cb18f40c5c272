#pragma once

#include "client/net/remote_source.h"
#include "common/result.h"
#include "protocol/packet.h"

namespace aucast::net {

/// Asks a server for its streams, in its order; a client that names none gets the first. Of each
/// there is what the server says, perhaps only the name. Of several servers the first that answers
/// is asked. Blocks until they have come, at most options.connect_timeout for each server and
/// `time_max` in all, of which each has an equal share of what is left. Network error otherwise,
/// naming the servers and the causes. Only the options about the connection are used.
[[nodiscard]] Result<protocol::StreamList> list_streams(const RemoteOptions& options,
                                                        Duration time_max = Duration::max());

}  // namespace aucast::net
