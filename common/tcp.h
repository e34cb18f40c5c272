#pragma once

#include "common/time.h"

namespace aucast {

/// When a peer counts as vanished that says no word.
struct VanishedAfter {
  /// Nothing is under way to it: so long silent, then asked so many times so far apart. Whole
  /// seconds.
  Milliseconds idle{0};
  Milliseconds interval{0};
  int probes = 0;
  /// Something is under way to it: so long not acknowledged, or not taken.
  Milliseconds unanswered{0};
};

/// Has the system end the connection when the peer has vanished. `socket`: a descriptor. A system
/// that refuses any of it still has a connection.
void find_vanished_peer(int socket, const VanishedAfter& after);

/// The connection's smoothed round trip as the system has measured it; zero when it does not tell.
[[nodiscard]] Duration round_trip(int socket);

}  // namespace aucast
