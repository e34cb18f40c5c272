#pragma once

#include <string>

namespace aucast::voice {

/// What the end of a sound file shows about whether it was cut off; decoders do not report that.
struct ContainerEnd {
  std::string missing;       ///< what is missing, in words; empty: nothing, as far as one can see
  bool within_page = false;  ///< Ogg that does not end with a whole page: its length is unknown
};

/// Looks at WAV (and RF64) and Ogg. A WAV file that was written to a pipe gives a false size
/// of its sound (0, or about 2 or 4 GiB); that alone does not count as cut off.
[[nodiscard]] ContainerEnd container_end(int descriptor);

}  // namespace aucast::voice
