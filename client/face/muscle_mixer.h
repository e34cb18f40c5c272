#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/face/face.h"
#include "common/action_unit.h"

namespace aucast::face {

/// How the recordings of several AUs become one activation per channel (thesis 5.4.4.5).
enum class Mixer : std::uint8_t {
  Maximum,  ///< max of intensity x recorded activation (table 5.2)
  Average,  ///< over the AUs that use the channel: sum(i a) / sum(i) x max(i) (table 5.1 at 100 %)
};

/// Fills `activations` (one per channel of the face). A channel of the left side takes the left
/// intensities, a central one the larger side. AU46 on both sides alike winks the right one. An AU
/// without recording does nothing.
void mix(const Face& face, const AuFrame& frame, Mixer mixer, std::span<float> activations);

}  // namespace aucast::face
