#pragma once

#include <algorithm>

#include "common/time.h"

namespace aucast::app {

/// The time of a video that is made in real time, with long gaps cut short. Without this, after the
/// program was stopped or the machine slept for a long time, one frame of the window would have to
/// make a picture for each moment that was missed.
class VideoTime {
 public:
  /// The length that a longer gap is cut to.
  static constexpr Milliseconds kGapMax{10'000};

  explicit VideoTime(Instant begin) : begin_(begin), newest_(begin) {}

  /// The place in the video of what is shown or heard at `time`. Times need not ascend.
  [[nodiscard]] Duration place_of(Instant time) {
    if (time - newest_ > kGapMax) begin_ += time - newest_ - kGapMax;
    newest_ = std::max(newest_, time);
    return time - begin_;
  }

 private:
  Instant begin_;   ///< moved on by what was left out
  Instant newest_;  ///< the latest of the times so far
};

}  // namespace aucast::app
