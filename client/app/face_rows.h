#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/options.h"

namespace aucast::app {

/// Which face is shown, and how AUs that share a muscle come together in it.
[[nodiscard]] std::vector<OptionRow> face_rows(FaceOptions& face);

/// The rules between AUs, and where the data is.
[[nodiscard]] std::vector<OptionRow> rules_rows(FaceOptions& face);

/// How the face moves.
[[nodiscard]] std::vector<OptionRow> animation_rows(PlaybackOptions& playback);

}  // namespace aucast::app
