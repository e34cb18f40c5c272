#pragma once

#include <filesystem>

#include "client/app/notices.h"
#include "client/app/window/files/file_session.h"
#include "client/app/window/playing/playback_session.h"
#include "common/result.h"

namespace aucast::app {

/// Plays a stream file, or a table, and tells how the table was read. A sound file is heard with
/// the stream that plays, as if it lay beside that; a film is refused. Returns true if the face
/// that plays is to be shown.
[[nodiscard]] Result<bool> play_file(const std::filesystem::path& file, FileSession& files,
                                     PlaybackSession& playback, Notices& notices, Instant now);

}  // namespace aucast::app
