#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/gui/emotion_pad.h"

namespace aucast::gui {

/// A keyframe of the composer's timeline as a line.
struct TimelineRow {
  std::string aus;   ///< "1,2,5:25"
  std::string time;  ///< "500 ms"
  friend bool operator==(const TimelineRow&, const TimelineRow&) = default;
};

/// An AU of the keyframe being composed.
struct ComposedAu {
  int number = 0;
  std::string name;
  int left_percent = 0;
  int right_percent = 0;
  friend bool operator==(const ComposedAu&, const ComposedAu&) = default;
};

struct ComposerView {
  bool active = false;    ///< the face shows the keyframe being composed
  bool can_take = false;  ///< the face shows AUs that are not from here
  std::shared_ptr<const std::vector<TimelineRow>> rows;  ///< always there
  std::string total;                                     ///< "3 keyframes, 1.5 s"
  int chosen = -1;                                       ///< -1: a new one
  std::vector<ComposedAu> aus;                           ///< of the chosen one or the new one
  int ms = -1;                                           ///< -1: no time of its own
  std::string file;
  bool unsaved = false;
  bool can_undo = false;
  bool can_redo = false;
  std::shared_ptr<const std::vector<PadPoint>> pad;  ///< always there
  std::optional<std::array<float, 2>> pad_at;        ///< where the pad was touched last
  friend bool operator==(const ComposerView&, const ComposerView&) = default;
};

// What may be asked of it.

struct ComposeAu {
  int number = 0;
  int left_percent = 0;
  int right_percent = 0;
  bool continued = false;
};
/// The face of a place on the pad of emotions.
struct ComposeMood {
  float x = 0;
  float y = 0;
  bool continued = false;
};
struct ComposeNeutral {};
/// The AUs that the face shows at this moment, from a stream or as an expression.
struct ComposeShown {};
struct ComposeTime {
  int ms = -1;  ///< -1: no time of its own
  bool continued = false;
};
struct AddKeyframe {};
struct ChooseKeyframe {
  int keyframe = -1;  ///< -1: a new one
};
struct RemoveKeyframe {};
struct MoveKeyframe {
  int direction = 1;
};
struct UndoComposing {};
struct RedoComposing {};
struct NewComposition {};
struct PlayComposition {};
/// Saves in the file that it came from; asks for one when there is none.
struct SaveComposition {};

using ComposerCommand =
    std::variant<ComposeAu, ComposeMood, ComposeNeutral, ComposeShown, ComposeTime, AddKeyframe,
                 ChooseKeyframe, RemoveKeyframe, MoveKeyframe, UndoComposing, RedoComposing,
                 NewComposition, PlayComposition, SaveComposition>;

}  // namespace aucast::gui
