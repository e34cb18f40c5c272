#pragma once

#include <optional>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "common/time.h"

namespace aucast::gui {

/// Moves from one face to another in a number of in-between frames, each shown for the same time
/// (thesis 5.4.2: 50 frames of 5 ms). Pure: the times are handed in.
class Transition {
 public:
  /// Both faces have one activation per channel.
  Transition(std::vector<float> start, std::vector<float> end, TransitionSettings settings,
             Instant begin);

  /// The in-between frame at `now`: `start` until the first frame is due, and exactly `end` once
  /// the last one is due.
  [[nodiscard]] std::vector<float> at(Instant now) const;
  [[nodiscard]] bool over(Instant now) const;
  /// When the next frame is due; nullopt: the transition is over.
  [[nodiscard]] std::optional<Instant> next_frame_at(Instant now) const;

 private:
  [[nodiscard]] int frame_at(Instant now) const;

  std::vector<float> start_;
  std::vector<float> end_;
  TransitionSettings settings_;
  Instant begin_;
};

}  // namespace aucast::gui
