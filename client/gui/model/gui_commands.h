#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "client/view/viewpoint.h"

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
struct ChangeRendering {
  RenderingSettings settings;
};
struct ChangeDisplay {
  DisplaySettings settings;
};
struct LookFrom {
  view::ViewpointPreset view = view::ViewpointPreset::Front;
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

/// About what plays.
using PlaybackCommand = std::variant<Connect, Pause, Resume, Stop, LocalCommand>;
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
