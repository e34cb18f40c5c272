#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/app/player_options.h"
#include "client/playback/delay_meter.h"
#include "client/playback/keyframe_source.h"

namespace aucast::app {

/// Why --live has no effect on a stream.
enum class LiveObjection : std::uint8_t {
  None,        ///< --live has an effect, or was not given
  IsFile,      ///< there is no server
  IsClassic,   ///< a classic server cannot say that a stream is live
  IsRecorded,  ///< the server says that the stream is not live
};
[[nodiscard]] LiveObjection live_objection(const PlaybackOptions& options,
                                           const playback::SourceStatus& status);
/// A sentence for the terminal; empty for None.
[[nodiscard]] std::string_view terminal_text(LiveObjection objection);
/// The same in the words of the window.
[[nodiscard]] std::string window_text(LiveObjection objection);

/// "42 ms (at most 57, wanted 41)"; empty if nothing was measured.
[[nodiscard]] std::string delay_text(const playback::DelaySummary& delay, Milliseconds wanted);

}  // namespace aucast::app
