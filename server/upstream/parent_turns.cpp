#include "server/upstream/parent_turns.h"

#include <algorithm>

namespace aucast::server {

Milliseconds ParentTurns::next() {
  current_ = (current_ + 1) % parents_;
  if (++failures_ % parents_ != 0) return shortened(kNextMost);
  const Milliseconds wait = wait_;
  wait_ = std::min(wait_ * 2, kMost);
  return shortened(wait);
}

void ParentTurns::worked() {
  failures_ = 0;
  wait_ = kFirst;
}

/// By up to a half.
Milliseconds ParentTurns::shortened(Milliseconds wait) {
  std::uniform_int_distribution<Milliseconds::rep> part(0, wait.count() / 2);
  return wait - Milliseconds(part(random_));
}

}  // namespace aucast::server
