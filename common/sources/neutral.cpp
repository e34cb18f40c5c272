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

}  // namespace

void take_off(Signals& signals, const Signals& neutral) {
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    if (is_signal(neutral[channel])) signals[channel] -= neutral[channel];
  }
}

bool NeutralMeter::add(double seconds, const Signals& signals) {
  if (done_) return false;
  if (begin_ && seconds - *begin_ >= wanted_ - kSpanRounding) {
    done_ = true;
    return false;
  }
  if (std::none_of(signals.begin(), signals.end(), is_signal)) return true;
  if (!begin_) begin_ = seconds;
  if (seconds - begin_.value_or(seconds) >= kSecondsMax) return true;
  if (last_ && seconds - *last_ < std::min(wanted_, kSecondsMax) / kRowsMax) return true;
  last_ = seconds;
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
  const double span = begin_ ? std::round(*last_ - *begin_) : 0;
  MeasuredNeutral neutral{no_signals(), wanted_ > kSecondsMax ? span : wanted_, rows_};
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    neutral.signals[channel] = median(sorted_[channel]);
  }
  return neutral;
}

}  // namespace aucast::sources
