#include "server/voice/slow_line.h"

#include <algorithm>

namespace aucast::server {
namespace {

/// How far the line rises per second. Clocks differ by 100 millionths; ten times that lets it
/// correct an arrival that was too early.
constexpr double kRise = 1e-3;
/// Being kLate late for kLateTime is no jitter.
constexpr Seconds kLate(0.3);
constexpr Seconds kLateTime(2);

}  // namespace

void SlowLine::add(SteadyTime now, Seconds made) {
  const SteadyTime seems = now - made;
  if (!begin_ || seems <= *begin_) {
    begin_ = seems;
    late_since_.reset();
  } else {
    begin_ = std::min(*begin_ + kRise * (now - last_now_), seems);
    if (seems - *begin_ < kLate) {
      late_since_.reset();
    } else if (!late_since_) {
      late_since_ = now;
    } else if (now - *late_since_ >= kLateTime) {
      begin_ = seems;
      late_since_.reset();
    }
  }
  last_now_ = now;
}

}  // namespace aucast::server
