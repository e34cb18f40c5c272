#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/gui/model/au_curves.h"
#include "common/time.h"

namespace aucast::gui {

/// A stream that is available whole (a file, or a composed stream), and how far it has been played.
struct LocalView {
  bool open = false;
  std::string name;
  bool playing = false;
  Duration position{0};
  Duration total{0};
  std::shared_ptr<const std::vector<Duration>> ends;  ///< when each keyframe is reached; not null
                                                      ///< if `open`
  std::size_t keyframe = 0;                           ///< the keyframe under way, counted from 1
  int speed_percent = 100;
  std::optional<Duration> loop_begin;
  std::optional<Duration> loop_end;
  bool repeats = false;                      ///< the whole stream is repeated
  int step_fps = 25;                         ///< a step by frame is 1 / step_fps s
  std::shared_ptr<const AuCurves> curves{};  ///< one per AU; null: not known
  friend bool operator==(const LocalView&, const LocalView&) = default;
};

// The commands for such a stream, besides Pause and Resume.

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
  int direction = 1;  ///< 1: to the next of LocalPlayback::kSpeeds; -1: to the one before
};
struct MarkLoop {};
/// Turns the repetition of the whole stream on or off.
struct ToggleRepeat {};

using LocalCommand = std::variant<Seek, SeekBy, StepKeyframe, StepFrame, SetSpeed, ChangeSpeed,
                                  MarkLoop, ToggleRepeat>;

}  // namespace aucast::gui
