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

/// Has the buffers as the form of the window has them: how full, and how far behind.
void set_buffers(const gui::RemoteSettings& settings, playback::BufferOptions& buffers);

}  // namespace aucast::app
