#include "common/sources/neutral.h"

#include <algorithm>
#include <cmath>

namespace aucast::sources {
namespace {

/// More values would not change a median; of a faster source, rows are left out.
constexpr double kRowsMax = 2000;

/// Nor would rows that come later than this.
constexpr double kSecondsMax = 600;

/// The rounding error that times, which are sums of steps, may have.
constexpr double kSpanRounding = 1e-6;

float median(const std::vector<float>& sorted) {
  if (sorted.empty()) return kNoSignal;
  const std::size_t middle = sorted.size() / 2;
  if (sorted.size() % 2 == 1) return sorted[middle];
  return (sorted[middle - 1] + sorted[middle]) / 2;
}

float movement(const std::vector<float>& sorted) {
  if (sorted.empty()) return kNoSignal;
  const std::size_t tenth = (sorted.size() + 9) / 10;
  return sorted.size() <= 2 * tenth ? 0 : sorted[sorted.size() - 1 - tenth] - sorted[tenth];
}

}  // namespace

void take_off(Signals& signals, const Signals& neutral) {
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    if (is_signal(neutral[channel])) signals[channel] -= neutral[channel];
  }
}

bool NeutralMeter::add(double seconds, const Signals& signals) {
  if (done_) return false;
  if (begin_seconds_ && seconds - *begin_seconds_ >= wanted_seconds_ - kSpanRounding) {
    done_ = true;
    return false;
  }
  if (std::none_of(signals.begin(), signals.end(), is_signal)) return true;
  if (!begin_seconds_) begin_seconds_ = seconds;
  if (seconds - begin_seconds_.value_or(seconds) >= kSecondsMax) return true;
  if (last_seconds_ && seconds - *last_seconds_ < std::min(wanted_seconds_, kSecondsMax) / kRowsMax)
    return true;
  last_seconds_ = seconds;
  ++rows_;
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    if (!is_signal(signals[channel])) continue;
    auto& sorted = sorted_[channel];
    sorted.insert(std::upper_bound(sorted.begin(), sorted.end(), signals[channel]),
                  signals[channel]);
  }
  return true;
}

MeasuredNeutral NeutralMeter::measured() const {
  const double span = begin_seconds_ ? std::round(*last_seconds_ - *begin_seconds_) : 0;
  MeasuredNeutral neutral;
  neutral.seconds = wanted_seconds_ > kSecondsMax ? span : wanted_seconds_;
  neutral.rows = rows_;
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    neutral.signals[channel] = median(sorted_[channel]);
    neutral.movement[channel] = movement(sorted_[channel]);
  }
  return neutral;
}

}  // namespace aucast::sources
