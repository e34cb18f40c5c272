#include "server/streams/stream_summary.h"

#include <algorithm>

namespace aucast::server {

void StreamSummary::add(const protocol::Keyframe& keyframe, std::uint32_t keyframe_ms) {
  ++keyframes;
  if (!keyframe.time_ms) ++untimed;
  duration_ms += keyframe.time_ms.value_or(keyframe_ms);
  const AuFrame frame = frame_from_terms(keyframe.terms);
  const auto count = [this](std::size_t number, int percent) {
    Use& use = uses[number];
    ++use.keyframes;
    use.percent_low = std::min(use.percent_low, percent);
    use.percent_high = std::max(use.percent_high, percent);
  };
  bool neutral = true;
  for (std::size_t number = 1; number < uses.size(); ++number) {
    const int percent = percent_of(std::max(frame.left[number], frame.right[number]));
    if (percent == 0) continue;
    neutral = false;
    count(number, percent);
  }
  if (neutral) count(0, 100);
  for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
    const int there = percent_of(frame.left[kTurns[turn]]);
    const int back = percent_of(frame.left[kTurns[turn] + 1]);
    ++turns[turn][static_cast<std::size_t>(100 + there - back)];
  }
}

int StreamSummary::median_turn(std::size_t turn) const {
  std::size_t before = 0;
  std::size_t at = 0;
  while (at + 1 < turns[turn].size() && before + turns[turn][at] <= keyframes / 2) {
    before += turns[turn][at++];
  }
  return static_cast<int>(at) - 100;
}

}  // namespace aucast::server
