#pragma once

#include <algorithm>

#include "common/time.h"

namespace aucast::app {

/// The time of a video that is made of what happens meanwhile. A program that was stopped for a
/// long time, or a machine that slept, would otherwise have to be made up for by a picture for each
/// moment that it missed, all in one frame of the window.
class VideoTime {
 public:
  /// What is left of a longer time in which nothing happened.
  static constexpr Milliseconds kGapMax{10'000};

  explicit VideoTime(Instant begin) : begin_(begin), newest_(begin) {}

  /// Where in the video something is that is shown or heard at `time`, which need not ascend.
  [[nodiscard]] Duration place_of(Instant time) {
    if (time - newest_ > kGapMax) begin_ += time - newest_ - kGapMax;
    newest_ = std::max(newest_, time);
    return time - begin_;
  }

 private:
  Instant begin_;   ///< moved on by what was left out
  Instant newest_;  ///< of the times so far
};

}  // namespace aucast::app
