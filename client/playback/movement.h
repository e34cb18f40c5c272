#pragma once

#include <algorithm>

#include "common/time.h"

namespace aucast::playback {

/// Positions per keyframe: k/50, k = 1..50 (thesis 5.4.2).
inline constexpr int kPositionsPerKeyframe = 50;

/// A movement of the face from one pose to the next: how far it has come at a given time.
struct Movement {
  Instant begin{};
  Duration takes{0};  ///< 0: a jump, which ends as soon as it begins

  [[nodiscard]] Instant end() const { return begin + takes; }
  /// When position `k` is reached.
  [[nodiscard]] Instant reaches(int k) const { return begin + takes * k / kPositionsPerKeyframe; }
  /// How much of `takes` has passed.
  [[nodiscard]] Duration passed(Instant now) const {
    return std::clamp(now - begin, Duration::zero(), takes);
  }
  /// The last position that has been reached, 0..50.
  [[nodiscard]] int position(Instant now) const {
    if (takes == Duration::zero()) return kPositionsPerKeyframe;
    return static_cast<int>(passed(now) * kPositionsPerKeyframe / takes);
  }
  /// The exact fraction, in [0,1].
  [[nodiscard]] double mu(Instant now) const {
    if (takes == Duration::zero()) return 1;
    return static_cast<double>(passed(now).count()) / static_cast<double>(takes.count());
  }
};

}  // namespace aucast::playback
