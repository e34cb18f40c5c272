#pragma once

#include <span>
#include <string>

#include "client/playback/keyframe_source.h"
#include "common/time.h"

namespace aucast::app {

/// The AUs of keyframes as a table (CSV) with a row for each: time_s, when it is reached from the
/// beginning; duration_s; then a column for each AU that occurs, AU12, or AU12_left and AU12_right
/// where its sides differ somewhere, in percent. `untimed`: of keyframes without a time of their
/// own.
[[nodiscard]] std::string format_au_table(std::span<const playback::Keyframe> keyframes,
                                          Milliseconds untimed);

}  // namespace aucast::app
