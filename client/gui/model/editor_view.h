#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "client/gui/model/stream_view.h"

namespace aucast::gui {

/// A line of the expression editor: one channel, or a left and a right one under one name.
struct ChannelRow {
  std::string name;  ///< in words: "zygomaticus major"
  float maximum = 2;
  int left = -1;  ///< index of the left or the central channel; -1: there is none
  int right = -1;
  float left_value = 0;
  float right_value = 0;
  friend bool operator==(const ChannelRow&, const ChannelRow&) = default;
};

struct ChannelGroup {
  std::string_view name;
  std::vector<ChannelRow> rows;
  friend bool operator==(const ChannelGroup&, const ChannelGroup&) = default;
};

struct EditorView {
  bool active = false;  ///< the face shows what is edited
  bool aside = false;   ///< something is being edited, but the face shows something else
  std::vector<ChannelGroup> groups;  ///< the channels of what is edited or, if nothing is, of the
                                     ///< face that is shown
  bool linked = true;
  int au = -1;  ///< the AU being edited; -1: none
  bool unsaved = false;
  std::map<int, std::string> names;  ///< names of AUs that were typed and have not been saved yet
  bool can_undo = false;
  bool can_redo = false;
  std::vector<AuRow> compound;  ///< the AUs that were combined last; empty: none
  friend bool operator==(const EditorView&, const EditorView&) = default;
};

/// An AU in the editor's list.
struct AuEntry {
  int number = 0;
  std::string name;     ///< of FACS, or the user's own
  std::string muscles;  ///< what it drives: "zygomaticus major 0.8, lip corner 1"
  std::string looks;    ///< what a face with it looks like; empty: unknown
  bool own = false;     ///< the user has made or changed it
  bool shipped = true;  ///< the player came with it, or with another version
  friend bool operator==(const AuEntry&, const AuEntry&) = default;
};

enum class ExpressionKind : std::uint8_t {
  Main,   ///< the first of the sets of AUs with one label; shown as a button
  Macro,  ///< muscles, as in the expressions of Waters' program; shown as a button
  Other,  ///< another set of AUs with the same label; shown in a list
};

/// An expression to choose.
struct ExpressionButton {
  std::string label;
  std::string aus;  ///< as in a packet; "0" for muscles alone
  ExpressionKind kind = ExpressionKind::Main;
  std::string source{};  ///< who describes it in this way, in words
  std::string name{};    ///< its name on the command line; unlike a label, it is unique
  friend bool operator==(const ExpressionButton&, const ExpressionButton&) = default;
};

/// The named expressions, and the one that the face shows.
struct ExpressionsView {
  std::vector<ExpressionButton> buttons;
  int chosen = -1;    ///< index of the one that is shown; -1: none is, or it has been changed since
  int percent = 100;  ///< strength of the expression, 0-100
  std::string aus;    ///< AUs of the chosen one at this strength, as in a packet; empty: none
  friend bool operator==(const ExpressionsView&, const ExpressionsView&) = default;
};

/// How the face goes from what it shows to an expression.
struct TransitionSettings {
  static constexpr int kFramesMax = 500;
  static constexpr int kFrameMsMax = 1000;

  int frames = 50;   ///< number of in-between frames, 1 to kFramesMax
  int frame_ms = 5;  ///< 1 to kFrameMsMax
  bool cosine = false;
  friend bool operator==(const TransitionSettings&, const TransitionSettings&) = default;
};

// The commands of the expression panel and of the expression editor.

/// Goes from the face that is shown to expression `index` of the model.
struct ShowExpression {
  std::size_t index = 0;
};
/// The strength of the expression that is shown and of later ones: 0-100 % of its intensities.
struct ChangeStrength {
  int percent = 100;
  bool continued = false;  ///< as in SetChannel
};
struct ChangeTransition {
  TransitionSettings settings;
};
/// Sets a channel. With `continued` the change belongs to the same drag as the previous one, so
/// that undo takes both back as one step.
struct SetChannel {
  int channel = 0;
  float value = 0;
  bool continued = false;
};
struct SetLinked {
  bool linked = true;
};
struct LoadAu {
  int number = 0;
};
/// Shows on the face what is being edited.
struct ShowEdited {};
/// Saves what the editor's sliders show as this AU. `name`: for an AU that FACS does not name;
/// empty: its name stays.
struct SaveAu {
  int number = 0;
  std::string name{};
};
/// A name that was typed for an AU and has not been saved yet.
struct NameAu {
  int number = 0;
  std::string name;
};
/// Removes the user's version of an AU. If the player came with the AU, the shipped version is used
/// again.
struct RemoveAu {
  int number = 0;
};
/// Applies rules and mixer to a set of AUs, written as in a packet, and takes the result into the
/// editor.
struct ShowAus {
  std::string aus;
};
struct RevertAu {};
struct NeutralFace {};
struct Undo {};
struct Redo {};
using EditorCommand =
    std::variant<ShowExpression, ChangeStrength, ChangeTransition, SetChannel, SetLinked, LoadAu,
                 ShowEdited, SaveAu, NameAu, RemoveAu, RevertAu, NeutralFace, Undo, Redo, ShowAus>;

}  // namespace aucast::gui
