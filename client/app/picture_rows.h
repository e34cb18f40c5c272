#pragma once

#include <vector>

#include "client/app/player_options.h"
#include "common/options.h"

namespace aucast::app {

/// How pictures look.
[[nodiscard]] std::vector<OptionRow> picture_rows(OutputOptions& output);

/// Where the face of a picture is looked at from.
[[nodiscard]] OptionRow viewpoint_row(PoseOptions& pose);

}  // namespace aucast::app
