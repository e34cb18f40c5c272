#include "client/app/remote_options.h"

#include <utility>

namespace aucast::app {

net::RemoteOptions remote_options(const PlaybackOptions& options, const net::Endpoint& endpoint,
                                  net::Security security) {
  net::RemoteOptions remote;
  static_cast<net::StreamRequest&>(remote) = options;
  remote.host = endpoint.host;
  remote.port = endpoint.port;
  remote.others = options.others;
  remote.connect_timeout = options.connect_timeout;
  remote.security = std::move(security);
  return remote;
}

void set_buffers(const gui::RemoteSettings& settings, playback::BufferOptions& buffers) {
  buffers.receiver_capacity = static_cast<std::size_t>(settings.buffer);
  buffers.playout_capacity = static_cast<std::size_t>(settings.playout);
  buffers.threshold_percent = settings.threshold_percent;
  buffers.low_delay = settings.behind == gui::Behind::Live;
  buffers.by_time = settings.behind == gui::Behind::Auto || settings.behind == gui::Behind::Time;
  if (!buffers.by_time) return;
  buffers.receiver_capacity = playback::kReceiverSetsByTime;
  buffers.adapt = settings.behind == gui::Behind::Auto;
  if (!buffers.adapt) buffers.live_delay = Milliseconds(settings.behind_ms);
}

}  // namespace aucast::app
