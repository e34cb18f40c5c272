#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "client/playback/keyframe_list.h"
#include "common/time.h"

namespace aucast::gui {

// How strong each AU is over the time of a stream that is available whole. Values go in straight
// lines from keyframe to keyframe, beginning with the neutral face. Pure.

/// The curve of one AU that occurs. `values`: in [0,1], one per keyframe; if the sides differ, the
/// stronger one's.
struct AuCurve {
  int number = 0;
  std::vector<float> values;
  friend bool operator==(const AuCurve&, const AuCurve&) = default;
};
using AuCurves = std::vector<AuCurve>;

/// The curves of a stream, sorted by AU number.
[[nodiscard]] AuCurves curves_of(const playback::KeyframeList& keyframes);

/// The value at a place of the stream. `ends`: the place at which each keyframe is reached,
/// ascending.
[[nodiscard]] float value_at(const AuCurve& curve, const std::vector<Duration>& ends,
                             Duration place);

/// The curve as drawn in `columns` (at least 2) columns of equal width: the largest value in each,
/// so that no peak is lost.
[[nodiscard]] std::vector<float> outline_of(const AuCurve& curve, const std::vector<Duration>& ends,
                                            std::size_t columns);

}  // namespace aucast::gui
