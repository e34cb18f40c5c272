#pragma once

#include <optional>
#include <string>

#include "client/playback/keyframe_buffers.h"
#include "common/time.h"

namespace aucast::net {

/// What is asked of a server, and how what it sends is received.
struct StreamRequest {
  bool classic = false;   ///< never send a hello
  std::string stream;     ///< empty: the server's first
  bool voice = false;     ///< ask for the stream's voice
  bool captions = false;  ///< ask for its captions
  playback::BufferOptions buffers;
  std::optional<Milliseconds> speed{};  ///< the time of keyframes that have none of their own;
                                        ///< nullopt: what the server's hello says
  /// Try again when the connection is lost or cannot be made.
  bool reconnect = false;
  /// With `reconnect`: until a server has been reached, each of several hosts is tried only once.
  bool one_round = false;
};

}  // namespace aucast::net
