#pragma once

#include <filesystem>
#include <memory>

#include "client/app/player_options.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_track.h"
#include "common/result.h"

namespace aucast::app {

/// The device that the options ask for; null when they ask for none, or when there is none, which
/// is then logged. If nothing would play the voice, `options` no longer asks for it.
[[nodiscard]] std::unique_ptr<sound::SoundOut> open_sound(PlayerOptions& options);

/// A sound file. Its failures are those of a file.
[[nodiscard]] Result<std::unique_ptr<sound::SoundTrack>> open_sound_file(
    const std::filesystem::path& sound_file);

/// The sound file beside a stream file; null: there is none. Its failures are those of a file.
[[nodiscard]] Result<std::unique_ptr<sound::SoundTrack>> open_sound_beside(
    const std::filesystem::path& stream_file);

}  // namespace aucast::app
