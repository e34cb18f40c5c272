#pragma once

#include "client/app/player_options.h"
#include "client/gui/model/remote_settings.h"
#include "client/net/remote_source.h"

namespace aucast::app {

/// The options for a connection to `endpoint`. `security`: loaded from PlaybackOptions::security,
/// or whatever else protects the connection.
[[nodiscard]] net::RemoteOptions remote_options(const PlaybackOptions& options,
                                                const net::Endpoint& endpoint,
                                                net::Security security);

/// Copies settings from the window's form into `buffers`: the sizes and thresholds of the buffers,
/// and how far the face may be behind the server.
void set_buffers(const gui::RemoteSettings& settings, playback::BufferOptions& buffers);

}  // namespace aucast::app
