#include "server/sources/dead_band.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace aucast::sources {
namespace {

int percent_of(float intensity) {
  return static_cast<int>(std::lround(intensity * 100.0F));
}

void settle_side(const std::array<float, kAuCount>& from, int band,
                 std::array<float, kAuCount>& shown) {
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const int now = percent_of(from[number]);
    if (now == 0 || std::abs(now - percent_of(shown[number])) >= band) {
      shown[number] = from[number];
    }
  }
}

}  // namespace

AuFrame DeadBand::settle(const AuFrame& frame) {
  settle_side(frame.left, percent_, shown_.left);
  settle_side(frame.right, percent_, shown_.right);
  return shown_;
}

void apply_dead_band(protocol::StreamFile& stream, int percent) {
  DeadBand band(percent);
  for (protocol::Keyframe& keyframe : stream.keyframes) {
    keyframe.terms = canonical_terms(band.settle(frame_from_terms(keyframe.terms)));
  }
}

}  // namespace aucast::sources
