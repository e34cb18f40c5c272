#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "client/app/window/making/face_session.h"
#include "client/gui/model/gui_commands.h"
#include "common/result.h"

namespace aucast::app {

/// Shows the face in this folder in the window.
using ShowFolder = std::function<Result<void>(const std::filesystem::path& folder)>;

/// Does what a panel asked for with a face: shows, copies, renames or deletes it; a face that is
/// shown is never one that is gone. Returns what is to be said about it; empty: nothing.
[[nodiscard]] Result<std::string> carry_out(const gui::FaceCommand& command, FaceSession& faces,
                                            const ShowFolder& show);

}  // namespace aucast::app
