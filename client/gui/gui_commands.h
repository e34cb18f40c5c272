#pragma once

#include <string>
#include <variant>
#include <vector>

#include "client/gui/gui_model.h"

namespace aucast::gui {

// What the panels ask for: plain data. Whoever owns the player carries it out.

struct Connect {
  RemoteSettings settings;
};
struct Pause {};
struct Resume {};
struct Stop {};
struct ChangeAnimation {
  AnimationSettings settings;
};
/// Goes from the face as it is to expression `index` of the model.
struct ShowExpression {
  std::size_t index = 0;
};
struct ChangeTransition {
  TransitionSettings settings;
};
/// Sets a channel; with `continued` it belongs to the drag that the call before began, so that both
/// are one step for undo.
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
/// Saves the face shown as this AU.
struct SaveAu {
  int number = 0;
};
/// A set of AUs as a packet has it, taken into the editor as mixer and rules make it.
struct ShowAus {
  std::string aus;
};
struct RevertAu {};
struct NeutralFace {};
struct Undo {};
struct Redo {};
struct ChangeRendering {
  RenderingSettings settings;
};
struct LookFrom {
  View view = View::Front;
};
/// The user's answer when there are unsaved changes.
struct Leave {
  bool really = false;
};

/// Opens the file dialog.
struct Browse {
  Purpose purpose = Purpose::PlayStream;
};
struct EnterFolder {
  std::string folder;
};
/// The file that the dialog was for.
struct ChooseFile {
  std::string file;
};
struct CloseBrowser {};
/// Plays a stream file from its beginning.
struct OpenStream {
  std::string file;
};
struct CloseNotice {};
struct TakePicture {};
/// Begins a video of what is shown, or ends it.
struct ToggleVideo {};

using GuiCommand =
    std::variant<Connect, Pause, Resume, Stop, ChangeAnimation, ShowExpression, ChangeTransition,
                 SetChannel, SetLinked, LoadAu, SaveAu, RevertAu, NeutralFace, Undo, Redo,
                 ChangeRendering, LookFrom, Leave, LocalCommand, ComposerCommand, Browse,
                 EnterFolder, ChooseFile, CloseBrowser, OpenStream, CloseNotice, ShowAus,
                 TakePicture, ToggleVideo>;
using GuiCommands = std::vector<GuiCommand>;

}  // namespace aucast::gui
