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

/// AUs that only one side can show at a time: the jaw sideways, the tongue in a cheek, a wink.
[[nodiscard]] bool shows_on_one_side(int number);

/// Fills `activations` (one per channel of the face). A channel of the left side takes the left
/// intensities, a central one the larger side. An AU that shows on one side only is the right one's
/// when both sides have it alike. An AU without recording does nothing.
void mix(const Face& face, const AuFrame& frame, Mixer mixer, std::span<float> activations);

}  // namespace aucast::face
