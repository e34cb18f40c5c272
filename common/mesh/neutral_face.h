#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/au_weights.h"

namespace aucast::mesh {

/// The neutral face of a person, from pictures of them. Each measure is a median: usually over the
/// fifth of the pictures in which AUs are weakest; for brows, which may stay raised for seconds,
/// over the weaker half; for head and gaze over all, so that somebody who usually looks past the
/// camera counts as looking straight. In the result, lips are shut, and eyes are open at least 60 %
/// as far as the typical face's. If nothing was seen, returns the typical face.
[[nodiscard]] Measures find_neutral_face(std::span<const Measures> seen, const AuWeights& weights);

/// The median of each measure; the typical face when nothing was seen.
[[nodiscard]] Measures median_face(std::span<const Measures> seen, const AuWeights& weights);

/// find_neutral_face() for somebody who is still being watched, over the last kWatchedSeconds.
class RunningNeutralFace {
 public:
  explicit RunningNeutralFace(const AuWeights& weights) : weights_(weights) {}

  /// Takes the face seen at `seconds`, later than the last, and returns the neutral face as found
  /// so far.
  [[nodiscard]] const Measures& watch(double seconds, const Measures& seen);

  static constexpr double kWatchedSeconds = 60;

 private:
  void ease(double seconds);

  const AuWeights& weights_;
  std::deque<Measures> kept_;  ///< kKeptEach seconds apart
  std::optional<double> kept_at_;
  std::optional<double> eased_at_;
  std::optional<Measures> aim_;
  Measures neutral_;
};

}  // namespace aucast::mesh
