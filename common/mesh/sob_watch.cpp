#include "common/mesh/sob_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/au_numbers.h"

namespace aucast::mesh {
namespace {

/// From 0 at `begin` to 1 at `end`, whichever of them is the greater one.
float ramp(float begin, float end, float value) {
  return std::clamp((value - begin) / (end - begin), 0.0F, 1.0F);
}

float sob_of(const AuFrame& frame) {
  const auto mean = [&frame](std::uint8_t number) {
    return (frame.left[number] + frame.right[number]) / 2;
  };
  return ramp(0.15F, 0.30F, mean(kInnerBrowRaiser) - mean(kOuterBrowRaiser)) *
         ramp(0.50F, 0.35F, mean(kCheekRaiser));
}

}  // namespace

void SobWatch::watch(double seconds, AuFrame& frame) {
  const double past = seen_at_ ? std::max(seconds - *seen_at_, 0.0) : 0;
  seen_at_ = seconds;
  const auto fade = static_cast<float>(std::exp(-past / kFadeSeconds));
  sob_ = std::max(sob_ * fade, sob_of(frame));
  for (auto* side : {&frame.left, &frame.right}) {
    float& smile = (*side)[kLipCornerPuller];
    float& stretch = (*side)[kLipStretcher];
    stretch = std::max(stretch, sob_ * smile);
    smile -= sob_ * smile;
  }
}

}  // namespace aucast::mesh
