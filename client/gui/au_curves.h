#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "client/playback/keyframe_source.h"
#include "common/time.h"

namespace aucast::gui {

// How strong each AU is over a stream that is there whole: from keyframe to keyframe in a straight
// line, from the neutral face on. Pure.

/// One AU that occurs; values in [0,1], one per keyframe, of the stronger side where they differ.
struct AuCurve {
  int number = 0;
  std::vector<float> values;
  friend bool operator==(const AuCurve&, const AuCurve&) = default;
};
using AuCurves = std::vector<AuCurve>;

/// Those of a stream, by number.
[[nodiscard]] AuCurves curves_of(std::span<const playback::Keyframe> keyframes);

/// The value at a place of the stream; `ends`: where each keyframe is reached, ascending.
[[nodiscard]] float value_at(const AuCurve& curve, const std::vector<Duration>& ends,
                             Duration place);

/// As it is drawn in that many columns of equal width, at least 2: the largest value in each, so
/// that no peak is lost.
[[nodiscard]] std::vector<float> outline_of(const AuCurve& curve, const std::vector<Duration>& ends,
                                            std::size_t columns);

}  // namespace aucast::gui
