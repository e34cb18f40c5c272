#pragma once

#include "common/time.h"

namespace aucast::test {

/// The steady time that many seconds after the clock's zero.
[[nodiscard]] constexpr SteadyTime at_second(double seconds) {
  return SteadyTime(Seconds(seconds));
}

}  // namespace aucast::test
