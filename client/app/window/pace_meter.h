#pragma once

#include <optional>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "common/time.h"

namespace aucast::app {

/// How long the stages of a frame took.
struct FrameTimes {
  Duration mix{};  ///< AUs to activations, and in-between frames
  Duration deform{};
  Duration face{};    ///< handing the face to OpenGL
  Duration panels{};  ///< panels, and waiting until everything is on the screen
};

/// The speed of drawing as the panel shows it: means over kFrames frames.
class PaceMeter {
 public:
  static constexpr int kFrames = 20;

  explicit PaceMeter(Instant begin) : begin_(begin) {}

  /// Adds a frame that was on the screen at `now`. After every kFrames frames returns their pace,
  /// else nullopt.
  [[nodiscard]] std::optional<std::vector<gui::PaceRow>> add(const FrameTimes& times, Instant now);

 private:
  Instant begin_;
  int frames_ = 0;
  FrameTimes sum_;
};

}  // namespace aucast::app
