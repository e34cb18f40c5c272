#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "client/app/player_options.h"
#include "client/sound/sound_out.h"
#include "client/sound/sound_track.h"
#include "common/result.h"

namespace aucast::app {

/// Opens the device that the options ask for. Returns null if they ask for none. If the device
/// cannot be opened, logs that, returns null and clears the request for a voice in `options`.
[[nodiscard]] std::unique_ptr<sound::SoundOut> open_sound(PlayerOptions& options);

/// Reads the sound file beside a stream file, until `stop` returns true; null: there is none.
/// Errors are those of reading it.
[[nodiscard]] Result<std::unique_ptr<sound::SoundTrack>> open_sound_beside(
    const std::filesystem::path& stream_file, const std::function<bool()>& stop);

}  // namespace aucast::app
