#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "common/mesh/measures.h"

namespace aucast::mesh {

/// Steadies the sideways gaze: each picture gets the median of itself and its two neighbours. The
/// first and last picture stay as they are.
void steady_gaze(std::span<Measures> film);

/// The same for live pictures: each gets the median of the last three, so a glance shows one
/// picture late.
class RunningSteadyGaze {
 public:
  [[nodiscard]] Measures watch(const Measures& seen);

 private:
  std::array<Measures, 3> last_{};
  std::size_t watched_ = 0;
};

}  // namespace aucast::mesh
