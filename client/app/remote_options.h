#pragma once

#include "client/app/player_options.h"
#include "client/net/remote_source.h"

namespace aucast::app {

/// What the options ask of a connection to `endpoint`; `security`: loaded from
/// PlaybackOptions::security, or what else protects it.
[[nodiscard]] net::RemoteOptions remote_options(const PlaybackOptions& options,
                                                const net::Endpoint& endpoint,
                                                net::Security security);

}  // namespace aucast::app
