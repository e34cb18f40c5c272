#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/au_weights.h"

namespace aucast::mesh {

/// The face at rest of somebody who was seen for a while: of the measures of the face the medians
/// of the quietest fifth of what was seen, those in which the fewest AUs show; of brows, which may
/// stay raised for seconds, of the quieter half; of head and gaze the medians of all, so that who
/// mostly looks past the camera looks straight. Its lips are shut and
/// its eyes open to 60 % of what is usual or more, whatever was seen. The typical face when nothing
/// was seen.
[[nodiscard]] Measures find_quiet_face(std::span<const Measures> seen, const AuWeights& weights);

/// The median of each measure; the typical face when nothing was seen.
[[nodiscard]] Measures median_face(std::span<const Measures> seen, const AuWeights& weights);

/// The same as find_quiet_face() of somebody who is still being watched: of the last
/// kWatchedSeconds.
class RunningQuietFace {
 public:
  explicit RunningQuietFace(const AuWeights& weights) : weights_(weights) {}

  /// A face at `seconds`, later than the one before; the quiet face by then.
  [[nodiscard]] const Measures& watch(double seconds, const Measures& seen);

  static constexpr double kWatchedSeconds = 60;

 private:
  void ease(double seconds);

  const AuWeights& weights_;
  std::deque<Measures> kept_;  ///< kKeptEach seconds apart
  std::optional<double> kept_at_;
  std::optional<double> eased_at_;
  std::optional<Measures> aim_;
  Measures quiet_;
};

}  // namespace aucast::mesh
