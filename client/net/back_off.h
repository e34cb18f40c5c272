#pragma once

#include <algorithm>

#include "common/time.h"

namespace aucast::net {

/// How long to wait before the next attempt to connect: 1, 2, 4 ... 30 s, and 30 s from then on.
/// Thread: none of its own.
class BackOff {
 public:
  static constexpr Milliseconds kFirst{1'000};
  static constexpr Milliseconds kWaitMax{30'000};

  /// The wait before the next attempt; each is twice the previous one.
  [[nodiscard]] Milliseconds next() {
    const Milliseconds wait = wait_;
    wait_ = std::min(wait_ * 2, kWaitMax);
    return wait;
  }
  /// Call it when an attempt has succeeded: the next wait is kFirst again.
  void reset() { wait_ = kFirst; }

 private:
  Milliseconds wait_ = kFirst;
};

}  // namespace aucast::net
