#pragma once

#include "common/time.h"

namespace aucast::playback {

/// Where playing is in a stream, and how fast it moves.
struct Passing {
  Duration place{0};  ///< on the stream's clock
  double speed = 0;   ///< seconds of the stream per second; 0: paused or waiting
};

}  // namespace aucast::playback
