#pragma once

#include <cstddef>

#include "common/time.h"

namespace aucast::link {

/// How many bytes are read from one peer before the others have their turn.
inline constexpr std::size_t kReadBytes = 1024;

/// Limits on the time and memory that one connection may take.
struct Limits {
  Milliseconds tls_handshake{0};
  /// Limits of draining: the longest time without progress, and how many bytes are read and dropped
  /// at most.
  Milliseconds drain_time{0};
  std::size_t drain_bytes = 0;
  /// While this many bytes or more wait to be sent, nothing is read: a peer that does not read
  /// cannot go on asking.
  std::size_t unsent_bytes = 0;

  // How a vanished peer is noticed. Where the system refuses one of these, the connection does
  // without it.

  /// While nothing is under way to the peer: probes begin after this silence (whole seconds) ...
  Milliseconds keep_alive_idle{0};
  Milliseconds keep_alive_interval{0};  ///< ... this far apart (whole seconds) ...
  int keep_alive_probes = 0;            ///< ... and this many unanswered ones end the connection.
  /// The longest time for which sent bytes may stay unacknowledged, or a peer whose buffer is full
  /// may take none.
  Milliseconds unanswered_time{0};

  std::size_t frame_bytes = 0;  ///< the most in one frame of a WebSocket; a longer frame is refused
  /// The silence after which a WebSocket's peer is sent a Ping; 0: never.
  Milliseconds ping_idle{0};
  Milliseconds pong_time{0};  ///< the longest wait for any bytes after the Ping
};

/// How connections are accepted.
struct AcceptLimits {
  int in_a_row = 1;       ///< how many are accepted before the connected clients have their turn
  Milliseconds pause{0};  ///< before the next attempt when the system is out of descriptors
};

}  // namespace aucast::link
