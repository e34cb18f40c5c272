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

/// Carries out a panel's command about a face: shows, copies, renames or deletes it. Before the
/// face in the window is deleted, shows another one. Returns a sentence for the user; empty: none.
[[nodiscard]] Result<std::string> carry_out(const gui::FaceCommand& command, FaceSession& faces,
                                            const ShowFolder& show);

}  // namespace aucast::app
