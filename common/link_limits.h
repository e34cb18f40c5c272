#pragma once

#include <cstddef>

#include "common/time.h"

namespace aucast::link {

/// Bytes read from one peer before the others have their turn.
inline constexpr std::size_t kReadBytes = 1024;

/// What one connection may cost in time and memory.
struct Limits {
  Milliseconds tls_handshake{0};
  /// Draining: the longest wait without progress, and what is read and dropped meanwhile.
  Milliseconds drain_time{0};
  std::size_t drain_bytes = 0;
  /// While so much waits to be sent, nothing is read: a peer that does not read cannot go on
  /// asking.
  std::size_t unsent_bytes = 0;

  // When a silent peer has vanished. A system that refuses any of it still has a connection.

  /// While nothing is under way to the peer: probes begin after this silence (whole seconds) ...
  Milliseconds keep_alive_idle{0};
  Milliseconds keep_alive_interval{0};  ///< ... this far apart (whole seconds) ...
  int keep_alive_probes = 0;            ///< ... and this many unanswered ones end the connection.
  /// The longest time that bytes under way to it may stay unacknowledged, or not be taken.
  Milliseconds unanswered_time{0};

  std::size_t frame_bytes = 0;  ///< of one frame of a WebSocket; longer ones are refused
  /// The silence after which a WebSocket's peer is sent a Ping; 0: never.
  Milliseconds ping_idle{0};
  Milliseconds pong_time{0};  ///< in which the peer must say something then
};

/// How connections are accepted.
struct AcceptLimits {
  int in_a_row = 1;       ///< accepted before the connected clients have their turn
  Milliseconds pause{0};  ///< before the next try when the system is out of descriptors
};

}  // namespace aucast::link
