#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "common/mesh/measures.h"

namespace aucast::mesh {

/// Steadies the sideways gaze of each eye: each picture gets the mean of its own gaze, which counts
/// twice, and the gazes of its two neighbours. The wider an eye is open, the more its gaze counts,
/// since a shut eye shows no iris. The first and last picture stay as they are.
void steady_gaze(std::span<Measures> film);

/// The same for live pictures: each picture gets the gaze that steady_gaze() gives the one before
/// it, so a glance appears one picture late.
class RunningSteadyGaze {
 public:
  [[nodiscard]] Measures watch(const Measures& seen);

 private:
  std::array<Measures, 3> last_{};  ///< the newest comes last
  std::size_t watched_ = 0;
};

}  // namespace aucast::mesh
