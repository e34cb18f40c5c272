#include "common/sources/one_euro.h"

#include <cmath>
#include <numbers>

#include "common/sources/hold.h"

namespace aucast::sources {
namespace {

/// The share of the new value in an exponential mean of that cutoff, `step` seconds after the last.
double share_of_new(double step, double cutoff_hz) {
  const double time_constant = 1 / (2 * std::numbers::pi * cutoff_hz);
  return 1 / (1 + time_constant / step);
}

double mean(double before, double now, double share) {
  return before + (now - before) * share;
}

}  // namespace

double OneEuro::next(double seconds, double value, const OneEuroSettings& settings) {
  const double step = seconds - seconds_;
  if (begun_ && step <= 0) return value_;
  if (!begun_ || step > kHoldSeconds) {
    begun_ = true;
    value_ = value;
    speed_ = 0;
  } else {
    const double speed = (value - value_) / step;
    speed_ = mean(speed_, speed, share_of_new(step, settings.derivative_cutoff_hz));
    const double cutoff_hz = settings.min_cutoff_hz + settings.beta * std::abs(speed_);
    value_ = mean(value_, value, share_of_new(step, cutoff_hz));
  }
  seconds_ = seconds;
  return value_;
}

void OneEuroBank::apply(double seconds, Signals& signals, const OneEuroSettings& settings) {
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    float& signal = signals[channel];
    if (!is_signal(signal)) continue;
    signal = static_cast<float>(filters_[channel].next(seconds, signal, settings));
  }
}

}  // namespace aucast::sources
