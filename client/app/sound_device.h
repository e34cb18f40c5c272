#pragma once

#include <filesystem>
#include <memory>

#include "client/app/player_options.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_track.h"
#include "common/result.h"

namespace aucast::app {

/// The device that the options want played on; null when they want none, or when there is none,
/// which the log then says. Voice is not asked for that nothing would play.
[[nodiscard]] std::unique_ptr<sound::SoundOut> open_sound(PlayerOptions& options);

/// The sound file beside a stream file; null: there is none. Its failures are those of a file.
[[nodiscard]] Result<std::unique_ptr<sound::SoundTrack>> open_sound_beside(
    const std::filesystem::path& stream_file);

}  // namespace aucast::app
