#pragma once

#include <filesystem>
#include <memory>

#include "client/app/player_options.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_track.h"
#include "common/result.h"

namespace aucast::app {

/// Opens the device that the options ask for. Returns null if they ask for none. If the device
/// cannot be opened, logs that, returns null and clears the request for a voice in `options`.
[[nodiscard]] std::unique_ptr<sound::SoundOut> open_sound(PlayerOptions& options);

/// Opens a sound file. Fails as sound::FileTrack::open() does.
[[nodiscard]] Result<std::unique_ptr<sound::SoundTrack>> open_sound_file(
    const std::filesystem::path& sound_file);

/// Opens the sound file beside a stream file. Returns null if there is none. Fails as
/// open_sound_file() does.
[[nodiscard]] Result<std::unique_ptr<sound::SoundTrack>> open_sound_beside(
    const std::filesystem::path& stream_file);

}  // namespace aucast::app
