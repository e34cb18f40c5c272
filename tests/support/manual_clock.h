#pragma once

#include "common/time.h"

namespace aucast::test {

/// A clock that stands until it is told to go on.
class ManualClock {
 public:
  [[nodiscard]] Instant now() const { return now_; }
  void advance(Duration by) { now_ += by; }

 private:
  Instant now_{std::chrono::hours(1)};
};

}  // namespace aucast::test
