#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "client/gui/gui_model.h"

namespace aucast::gui {

// What the panels ask for: plain data. Whoever owns the player carries it out.

struct Connect {
  RemoteSettings settings;
};
/// Asks the server of these settings for its streams.
struct AskStreams {
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
/// Of the expression that is shown, and of those to come: 0-100 % of all its intensities.
struct ChangeStrength {
  int percent = 100;
  bool continued = false;  ///< as in SetChannel
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
/// Saves the face shown as this AU; `name`, for one that FACS does not name, may be empty: as it
/// is.
struct SaveAu {
  int number = 0;
  std::string name{};
};
/// A name that was typed for an AU and is not saved yet.
struct NameAu {
  int number = 0;
  std::string name;
};
/// One's own AU goes; one that came with the player is as it came again.
struct RemoveAu {
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
struct ChangeDisplay {
  DisplaySettings settings;
};
struct LookFrom {
  Facing view = Facing::Front;
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
/// How the table is read that the open dialog is about to open.
struct ChangeTable {
  TableSettings settings;
};
/// The face becomes the one of this folder, with which the window begins next time too.
struct ShowFace {
  std::string folder;
};
struct CloseNotice {};
/// Where pictures and videos go from now on.
struct ChangePictures {
  PictureSettings settings;
};
struct TakePicture {};
/// The file that is being written in the background is not wanted any more.
struct CancelExport {};
/// The times at which faces are shown are not written any more.
struct EndOnsets {};
/// Begins a video of what is shown, or ends it.
struct ToggleVideo {};

struct SetVolume {
  int percent = 100;
};
struct ToggleMute {};
/// Looks which devices there are.
struct ListDevices {};
/// The sound goes there from now on; empty: to the usual one.
struct ChooseDevice {
  std::string name;
};
struct ToggleCaptions {};
/// About what is heard and read.
using SoundCommand = std::variant<SetVolume, ToggleMute, ListDevices, ChooseDevice, ToggleCaptions>;

/// About what plays.
using PlaybackCommand = std::variant<Connect, Pause, Resume, Stop, LocalCommand>;
/// About the face of the expression panel.
using EditorCommand =
    std::variant<ShowExpression, ChangeStrength, ChangeTransition, SetChannel, SetLinked, LoadAu,
                 SaveAu, NameAu, RemoveAu, RevertAu, NeutralFace, Undo, Redo, ShowAus>;

/// About the file dialog, and what is opened.
using FileCommand =
    std::variant<Browse, EnterFolder, ChooseFile, CloseBrowser, OpenStream, ChangeTable>;
/// About what the window keeps of how things look.
using SettingsCommand =
    std::variant<ChangePictures, ChangeAnimation, ChangeRendering, ChangeDisplay>;

using GuiCommand =
    std::variant<PlaybackCommand, SoundCommand, EditorCommand, ComposerCommand, MirrorCommand,
                 GalleryCommand, FileCommand, SettingsCommand, AskStreams, LookFrom, Leave,
                 ShowFace, CloseNotice, CancelExport, EndOnsets, TakePicture, ToggleVideo>;
using GuiCommands = std::vector<GuiCommand>;

/// The command when it is a `Wanted`, in whichever group that stands; else null.
template <typename Wanted, typename Command>
[[nodiscard]] const Wanted* command_if(const Command& command) {
  if constexpr (std::is_same_v<Wanted, Command>) {
    return &command;
  } else if constexpr (requires { std::variant_size<Command>::value; }) {
    return std::visit([](const auto& one) { return command_if<Wanted>(one); }, command);
  } else {
    return nullptr;
  }
}

}  // namespace aucast::gui
