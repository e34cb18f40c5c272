#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "common/time.h"
#include "protocol/encoded_stream.h"
#include "protocol/live_channel.h"
#include "protocol/voice_track.h"

namespace aucast::protocol {

/// A stream that another server sends, as far as it is known: at first not even of which kind it
/// is. Shared by all its sessions. Whoever receives it writes it; what is known does not change any
/// more, except that a recorded stream grows.
/// Thread: that of the sessions.
struct UpstreamStream {
  std::string name;  ///< empty: not known yet
  /// One of these two is set when the stream is known.
  std::shared_ptr<const EncodedStream> recorded;
  std::shared_ptr<const LiveChannel> live;
  std::shared_ptr<const Soundtrack> sound;  ///< of the recorded one; null: it has none
  bool loop = false;                        ///< the recorded one starts again at its end
  std::string title;                        ///< for people; empty: none
  std::uint32_t keyframe_ms = 250;          ///< time of a keyframe without its own
  std::string servers;       ///< that it comes through, as server_chain.h has them; without our own
  Milliseconds patience{0};  ///< how long a client waits for a stream that is not known yet
};

}  // namespace aucast::protocol
