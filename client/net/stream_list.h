#pragma once

#include "client/net/remote_source.h"
#include "common/result.h"
#include "protocol/packet.h"

namespace aucast::net {

/// Asks a server for its streams. They come in the server's order: a client that names no stream
/// gets the first. What is known of a stream is what the server says, perhaps only its name.
/// Several servers are asked in turn until one answers. Blocks until the answer has come: at most
/// options.connect_timeout for each server and `time_max` in all. Each server may take an equal
/// share of the time that is left. If none answers, fails with Network and a message that names the
/// servers and the causes. Uses only the options that concern the connection.
[[nodiscard]] Result<protocol::StreamList> list_streams(const RemoteOptions& options,
                                                        Duration time_max = Duration::max());

}  // namespace aucast::net
