#include "common/sources/signals.h"

#include <algorithm>

namespace aucast::sources {
namespace {

/// The second of each is the next number.
constexpr std::array<std::size_t, 6> kFirstDirections{kHeadLeft,    kHeadUp,   kHeadTiltLeft,
                                                      kHeadForward, kEyesLeft, kEyesUp};

float intensity(float signal) {
  return std::clamp(signal, 0.0F, 1.0F);
}

}  // namespace

Signals no_signals() {
  Signals signals;
  signals.fill(kNoSignal);
  return signals;
}

AuFrame no_data() {
  AuFrame update;
  update.left.fill(-1);
  update.right.fill(-1);
  return update;
}

std::size_t opposite_of(std::size_t number) {
  for (const std::size_t first : kFirstDirections) {
    if (number == first) return first + 1;
    if (number == first + 1) return first;
  }
  return 0;
}

bool is_second_direction(std::size_t number) {
  const std::size_t opposite = opposite_of(number);
  return opposite != 0 && opposite < number;
}

std::size_t shown_by(std::size_t number, float signal) {
  const std::size_t opposite = opposite_of(number);
  return signal < 0 && opposite != 0 ? opposite : number;
}

Signals signals_of(const AuFrame& update) {
  Signals signals = no_signals();
  for (const bool right : {false, true}) {
    const auto& values = right ? update.right : update.left;
    for (std::size_t number = 1; number < kAuCount; ++number) {
      if (values[number] < 0) continue;
      const bool second = is_second_direction(number);
      float& signal = signals[channel_of(second ? number - 1 : number, right)];
      const float before = is_signal(signal) ? signal : 0.0F;
      signal = second ? before - values[number] : values[number];
    }
  }
  return signals;
}

AuFrame update_of(const Signals& signals) {
  AuFrame update = no_data();
  for (const bool right : {false, true}) {
    auto& values = right ? update.right : update.left;
    for (std::size_t number = 1; number < kAuCount; ++number) {
      const float signal = signals[channel_of(number, right)];
      if (!is_signal(signal)) continue;
      values[number] = intensity(signal);
      if (const std::size_t opposite = opposite_of(number)) values[opposite] = intensity(-signal);
    }
  }
  return update;
}

}  // namespace aucast::sources
