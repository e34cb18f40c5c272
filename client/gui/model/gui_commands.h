#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "client/gui/model/gui_model.h"

namespace aucast::gui {

// What the panels ask for, as plain data. The owner of the player carries the commands out.

struct Connect {
  RemoteSettings settings;
};
/// Asks the server in these settings for its streams.
struct AskStreams {
  RemoteSettings settings;
};
struct Pause {};
struct Resume {};
struct Stop {};
struct ChangeAnimation {
  AnimationSettings settings;
};
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
struct ChangeRendering {
  RenderingSettings settings;
};
struct ChangeDisplay {
  DisplaySettings settings;
};
struct LookFrom {
  Facing view = Facing::Front;
};
/// The user's answer to the question whether to leave with unsaved changes.
struct Leave {
  bool really = false;
  bool saves = false;  ///< saves what is unsaved, and leaves if that works
};

/// Opens the file dialog.
struct Browse {
  Purpose purpose = Purpose::PlayStream;
};
struct EnterFolder {
  std::string folder;
};
/// The file chosen in the dialog.
struct ChooseFile {
  std::string file;
};
struct CloseBrowser {};
/// Plays a stream file from its beginning.
struct OpenStream {
  std::string file;
};
/// How to read the table that is about to be opened in the dialog.
struct ChangeTable {
  TableSettings settings;
};
struct CloseNotice {};
/// Changes where pictures and videos go, and how large they are.
struct ChangePictures {
  PictureSettings settings;
};
struct TakePicture {};
/// Cancels the writing of the GLB file in the background.
struct CancelExport {};
/// Ends the writing of the times at which faces are shown.
struct EndOnsets {};
/// Begins a video of what is shown, or ends it.
struct ToggleVideo {};

struct SetVolume {
  int percent = 100;
};
struct ToggleMute {};
/// Looks up which sound devices there are.
struct ListDevices {};
/// Chooses the sound device; empty: the default one.
struct ChooseDevice {
  std::string name;
};
struct ToggleCaptions {};
/// About sound and captions.
using SoundCommand = std::variant<SetVolume, ToggleMute, ListDevices, ChooseDevice, ToggleCaptions>;

/// About what plays.
using PlaybackCommand = std::variant<Connect, Pause, Resume, Stop, LocalCommand>;
/// About the face of the expression panel.
using EditorCommand =
    std::variant<ShowExpression, ChangeStrength, ChangeTransition, SetChannel, SetLinked, LoadAu,
                 ShowEdited, SaveAu, NameAu, RemoveAu, RevertAu, NeutralFace, Undo, Redo, ShowAus>;

/// About the file dialog, and what is opened.
using FileCommand =
    std::variant<Browse, EnterFolder, ChooseFile, CloseBrowser, OpenStream, ChangeTable>;
/// About settings that the window keeps.
using SettingsCommand =
    std::variant<ChangePictures, ChangeAnimation, ChangeRendering, ChangeDisplay>;

using GuiCommand =
    std::variant<PlaybackCommand, SoundCommand, EditorCommand, ComposerCommand, MirrorCommand,
                 GalleryCommand, FileCommand, SettingsCommand, FaceCommand, AskStreams, LookFrom,
                 Leave, CloseNotice, CancelExport, EndOnsets, TakePicture, ToggleVideo>;
using GuiCommands = std::vector<GuiCommand>;

/// Returns the `Wanted` that `command` is, or holds if it is a group of commands; null if neither.
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
