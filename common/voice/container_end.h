#pragma once

#include <string>

namespace aucast::voice {

/// How the end of a sound file shows that it was cut off, which decoders do not tell.
struct ContainerEnd {
  std::string missing;  ///< what is missing, in words; empty: it is whole, as far as one can see
  bool within_page = false;  ///< of Ogg: no whole page is at its end, and so its length is unknown
};

/// Looks at WAV (and RF64) and Ogg. A WAV file that was written to a pipe does not know how much
/// sound it has (0, or about 2 or 4 GiB), and is not cut off for that.
[[nodiscard]] ContainerEnd container_end(int descriptor);

}  // namespace aucast::voice
