#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/options.h"

namespace aucast::app {

/// What is heard, and the file that it is written to.
[[nodiscard]] std::vector<OptionRow> sound_rows(SoundOptions& sound);

/// Pictures a second.
[[nodiscard]] OptionRow fps_row(OutputOptions& output);

/// The files that tell of what was played: pictures, videos, numbers.
[[nodiscard]] std::vector<OptionRow> recording_rows(OutputOptions& output);

}  // namespace aucast::app
