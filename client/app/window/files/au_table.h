#pragma once

#include <string>

#include "client/playback/keyframe_list.h"
#include "common/time.h"

namespace aucast::app {

/// The AUs of keyframes as a table (CSV) with a row for each keyframe. Its columns: time_s, when
/// the keyframe is reached, counted from the beginning; duration_s; and the intensity of each AU
/// that occurs, in percent. An AU has one column such as AU12, or two, AU12_left and AU12_right, if
/// its sides differ anywhere. `untimed`: the time of keyframes that have none of their own.
[[nodiscard]] std::string format_au_table(const playback::KeyframeList& keyframes,
                                          Milliseconds untimed);

}  // namespace aucast::app
