#pragma once

#include <cstdint>

namespace aucast::playback {

/// What an idle face does besides blinking.
struct IdleMotion {
  double gaze_left_deg = 0;  ///< to the subject's left
  double gaze_up_deg = 0;
  double breath = 0;  ///< from 0, breathed out, to 1, breathed in
};

/// Small saccades and breath as a pure function of time: the same seed does the same at the same
/// moments, whatever was asked before.
///
/// A saccade begins every second and a half on average. One takes the eyes from the viewer to a
/// place 1 to 3 degrees away, more to the side than up or down; the next one brings them back. A
/// saccade of A degrees takes 25 ms + 2.4 ms x A (the main sequence as Lee, Badler and Badler 2002
/// give it for animated eyes), and is fastest in the middle; between two saccades at least 200 ms
/// pass. There are 12 to 16.5 breaths a minute (adults at rest breathe 12 to 20 times), no two
/// quite alike; breathing in takes two fifths of each.
[[nodiscard]] IdleMotion idle_motion(std::uint64_t seed, double seconds);

}  // namespace aucast::playback
