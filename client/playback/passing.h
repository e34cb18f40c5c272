#pragma once

#include "common/time.h"

namespace aucast::playback {

/// Where in a stream playing is, and how fast it moves there.
struct Passing {
  Duration place{0};  ///< on the stream's clock
  double speed = 0;   ///< stream time per time; 0: it stands
};

}  // namespace aucast::playback
