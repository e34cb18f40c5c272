#pragma once

#include <algorithm>

#include "client/face/muscle.h"

namespace aucast::test {

/// The shift of `point` from its place at rest by a muscle alone, without masks.
[[nodiscard]] inline glm::vec3 displacement(const face::MuscleShape& shape, const glm::vec3& point,
                                            float activation) {
  const face::LinearInfluence linear = face::influence(shape, point);
  return linear.per_unit * std::min(activation, linear.activation_cap);
}

}  // namespace aucast::test
