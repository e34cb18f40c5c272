#pragma once

#include "client/app/player_options.h"
#include "client/gui/remote_settings.h"
#include "client/net/remote_source.h"

namespace aucast::app {

/// What the options ask of a connection to `endpoint`; `security`: loaded from
/// PlaybackOptions::security, or what else protects it.
[[nodiscard]] net::RemoteOptions remote_options(const PlaybackOptions& options,
                                                const net::Endpoint& endpoint,
                                                net::Security security);

/// How far behind the window wants to be, as the buffers have it.
void set_behind(const gui::RemoteSettings& settings, playback::BufferOptions& buffers);

}  // namespace aucast::app
