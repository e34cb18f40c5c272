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
  Average,  ///< sum(i a) / sum(i) x max(i) over the AUs that use the channel, with intensity i and
            ///< recorded activation a (table 5.1 at 100 %)
};

/// "maximum" or "average", as in options and files.
[[nodiscard]] constexpr std::string_view name(Mixer mixer) {
  return mixer == Mixer::Average ? "average" : "maximum";
}

/// Fills `activations`, one per channel. A channel of one side takes that side's intensities, a
/// central one the larger of both. An AU without recording does nothing. Allocates nothing.
void mix(std::span<const Channel> channels, const AuRecordings& recordings, const AuFrame& frame,
         Mixer mixer, std::span<float> activations);

/// The same with the recordings that the face was loaded with.
inline void mix(const Face& face, const AuFrame& frame, Mixer mixer, std::span<float> activations) {
  mix(face.channels, face.recordings, frame, mixer, activations);
}

/// The AUs of `frame` for which the face has no recording, with their FACS names, such as "50
/// Speech, 84 Head Shake Back and Forth"; empty if there are none.
[[nodiscard]] std::string not_shown(const Face& face, const AuFrame& frame);

}  // namespace aucast::face
