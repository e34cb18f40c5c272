#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "common/mesh/measures.h"

namespace aucast::mesh {

/// Where eyes look to the side, without the trembling of single pictures: of every three pictures
/// of a film the median. What comes first and last stays.
void steady_gaze(std::span<Measures> film);

/// The same of somebody who is still being watched: the median of the last three pictures, so a
/// glance is told one picture late.
class RunningSteadyGaze {
 public:
  [[nodiscard]] Measures watch(const Measures& seen);

 private:
  std::array<Measures, 3> last_{};
  std::size_t watched_ = 0;
};

}  // namespace aucast::mesh
