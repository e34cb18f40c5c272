#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "client/face/face.h"
#include "common/action_unit.h"

namespace aucast::face {

/// How the recordings of several AUs become one activation per channel (thesis 5.4.4.5).
enum class Mixer : std::uint8_t {
  Maximum,  ///< max of intensity x recorded activation (table 5.2)
  Average,  ///< over the AUs that use the channel: sum(i a) / sum(i) x max(i) (table 5.1 at 100 %)
};

/// "maximum" or "average", as options and files have it.
[[nodiscard]] constexpr std::string_view name(Mixer mixer) {
  return mixer == Mixer::Average ? "average" : "maximum";
}

/// Fills `activations`, one per channel. A channel of the left side takes the left intensities, a
/// central one the larger side. An AU without recording does nothing. Allocates nothing.
void mix(std::span<const Channel> channels, const AuRecordings& recordings, const AuFrame& frame,
         Mixer mixer, std::span<float> activations);

/// With the recordings that the face was loaded with.
inline void mix(const Face& face, const AuFrame& frame, Mixer mixer, std::span<float> activations) {
  mix(face.channels, face.recordings, frame, mixer, activations);
}

/// What `frame` has and the face has no recording of, one after the other with its FACS name, such
/// as "50 Speech, 84 Head Shake Back and Forth"; empty when the face shows everything.
[[nodiscard]] std::string not_shown(const Face& face, const AuFrame& frame);

}  // namespace aucast::face
