#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/gui/model/emotion_pad.h"

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
  std::string name;  ///< of FACS, or the user's own
  int left_percent = 0;
  int right_percent = 0;
  friend bool operator==(const ComposedAu&, const ComposedAu&) = default;
};

struct ComposerView {
  bool active = false;    ///< the face shows the keyframe being composed
  bool aside = false;     ///< something is being composed, but the face shows something else
  bool can_take = false;  ///< the face shows AUs that do not come from the composer
  std::shared_ptr<const std::vector<TimelineRow>> rows;  ///< never null
  std::string total;                                     ///< "3 keyframes, 1.5 s"
  int chosen = -1;                                       ///< -1: a new one
  std::vector<ComposedAu> aus;                           ///< of the keyframe being composed
  std::optional<int> ms;                                 ///< nullopt: no time of its own
  std::string file;
  bool unsaved = false;  ///< the stream has unsaved changes; a new keyframe does not count
  bool begun = false;    ///< there is a new keyframe that was not added
  bool can_undo = false;
  bool can_redo = false;
  std::shared_ptr<const std::vector<PadPoint>> pad;  ///< never null
  std::optional<std::array<float, 2>> pad_at;  ///< where the pad was touched last; nullopt: not yet
  friend bool operator==(const ComposerView&, const ComposerView&) = default;
};

// The composer's commands.

struct ComposeAu {
  int number = 0;
  int left_percent = 0;
  int right_percent = 0;
  bool continued = false;
};
/// Takes the face of a place on the emotion pad; see pad_face().
struct ComposeMood {
  float x = 0;
  float y = 0;
  bool continued = false;
};
struct ComposeNeutral {};
/// Takes the AUs that the face shows now, whether a stream or an expression made them.
struct ComposeShown {};
struct ComposeTime {
  std::optional<int> ms;  ///< nullopt: no time of its own
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
/// Shows the keyframe being composed on the face again.
struct ShowComposed {};
struct PlayComposition {};
/// Saves in the file that the stream came from; asks for a file if there is none.
struct SaveComposition {};

using ComposerCommand =
    std::variant<ComposeAu, ComposeMood, ComposeNeutral, ComposeShown, ComposeTime, AddKeyframe,
                 ChooseKeyframe, RemoveKeyframe, MoveKeyframe, UndoComposing, RedoComposing,
                 NewComposition, ShowComposed, PlayComposition, SaveComposition>;

}  // namespace aucast::gui
