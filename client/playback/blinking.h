#pragma once

#include <cstdint>

namespace aucast::playback {

/// Blinking as a pure function of time: the same seed blinks at the same moments. One blink begins
/// in every interval of four seconds, at a random place of it, and takes 300 ms: 100 down, 50
/// closed, 150 up. Returns the closure of both lids in [0,1] at `seconds` >= 0.
[[nodiscard]] float blink_closure(std::uint64_t seed, double seconds);

}  // namespace aucast::playback
