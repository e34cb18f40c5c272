#pragma once

#include <string>

#include "client/app/player_options.h"
#include "client/playback/delay_meter.h"
#include "client/playback/keyframe_source.h"

namespace aucast::app {

/// Why --live changes nothing for this stream, a sentence; empty when it does, or was not asked
/// for.
[[nodiscard]] std::string live_objection(const PlaybackOptions& options,
                                         const playback::SourceStatus& status);

/// "42 ms (at most 57, wanted 41)"; empty when nothing was measured.
[[nodiscard]] std::string delay_text(const playback::DelaySummary& delay, Milliseconds wanted);

}  // namespace aucast::app
