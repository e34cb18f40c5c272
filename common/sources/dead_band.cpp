#include "common/sources/dead_band.h"

#include <cstddef>
#include <cstdlib>

namespace aucast::sources {

AuFrame DeadBand::settle(const AuFrame& frame) {
  for (const bool right : {false, true}) {
    const auto& from = right ? frame.right : frame.left;
    auto& shown = right ? shown_.right : shown_.left;
    for (std::size_t number = 1; number < kAuCount; ++number) {
      const int now = percent_of(from[number]);
      if (now == 0 || std::abs(now - percent_of(shown[number])) >= percent_.of(number, right)) {
        shown[number] = from[number];
      }
    }
  }
  return shown_;
}

void apply_dead_band(protocol::StreamFile& stream, const PerAu& percent) {
  DeadBand band(percent);
  for (protocol::Keyframe& keyframe : stream.keyframes) {
    keyframe.terms = canonical_terms(band.settle(frame_from_terms(keyframe.terms)));
  }
}

}  // namespace aucast::sources
