#include "server/upstream/host_turns.h"

#include <algorithm>

namespace aucast::server {

Milliseconds HostTurns::next() {
  current_ = (current_ + 1) % hosts_;
  if (++failures_ % hosts_ != 0) return shortened(kNextHostWaitMax);
  const Milliseconds wait = wait_;
  wait_ = std::min<Milliseconds>(wait_ * 2, kRedialWaitMax);
  return shortened(wait);
}

void HostTurns::worked() {
  failures_ = 0;
  wait_ = kRedialWaitFirst;
}

/// Shortens a wait by up to a half.
Milliseconds HostTurns::shortened(Milliseconds wait) {
  std::uniform_int_distribution<Milliseconds::rep> part(0, wait.count() / 2);
  return wait - Milliseconds(part(random_));
}

}  // namespace aucast::server
