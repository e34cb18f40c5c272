#pragma once

#include "common/action_unit.h"
#include "common/mesh/au_weights.h"

namespace aucast::mesh {

/// The Action Units of a face. Intensities are 0 to 1; those of turns of head and eyes (51-56,
/// 61-64) may be more. AUs that the weights do not know are 0.
[[nodiscard]] AuFrame read_aus(const AuWeights& weights, const Measures& seen,
                               const Measures& neutral);

}  // namespace aucast::mesh
