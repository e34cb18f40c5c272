#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/gui/au_curves.h"
#include "common/time.h"

namespace aucast::gui {

/// A stream that is there whole - a file, or what was composed - and where playing it stands.
struct LocalView {
  bool open = false;
  std::string name;
  bool playing = false;
  Duration position{0};
  Duration total{0};
  std::shared_ptr<const std::vector<Duration>> ends;  ///< of its keyframes; there when it is open
  std::size_t keyframe = 0;                           ///< the one under way, counted from 1
  int speed_percent = 100;
  std::optional<Duration> loop_begin;
  std::optional<Duration> loop_end;
  bool repeats = false;                      ///< the whole of it
  int step_fps = 25;                         ///< a step by frame is 1 / step_fps s
  std::shared_ptr<const AuCurves> curves{};  ///< of each AU; null: none are known
  friend bool operator==(const LocalView&, const LocalView&) = default;
};

// What may be asked of it, beside Pause and Resume.

struct Seek {
  Duration position{0};
};
struct SeekBy {
  Duration time{0};  ///< below 0: back
};
struct StepKeyframe {
  int direction = 1;  ///< -1: back
};
struct StepFrame {
  int direction = 1;
};
struct SetSpeed {
  int percent = 100;
};
struct ChangeSpeed {
  int direction = 1;  ///< to the next of the usual speeds
};
struct MarkLoop {};
/// Plays the whole of it again and again, or no more.
struct ToggleRepeat {};

using LocalCommand = std::variant<Seek, SeekBy, StepKeyframe, StepFrame, SetSpeed, ChangeSpeed,
                                  MarkLoop, ToggleRepeat>;

}  // namespace aucast::gui
