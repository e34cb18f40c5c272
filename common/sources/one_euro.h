#pragma once

#include <array>

#include "common/sources/signals.h"

namespace aucast::sources {

/// The settings of the One Euro filter. Signals are intensities, of which 1 is full: a smile that
/// comes in half a second has a speed of 2 per second.
struct OneEuroSettings {
  double min_cutoff_hz = 1;         ///< for a signal at rest, (0, 100]
  double beta = 5;                  ///< by how many Hz a speed of 1 raises the cutoff, [0, 100]
  double derivative_cutoff_hz = 1;  ///< of the speed, (0, 100]
  friend bool operator==(const OneEuroSettings&, const OneEuroSettings&) = default;
};

/// G. Casiez, N. Roussel, D. Vogel, "1 Euro filter", CHI 2012, algorithm 1, for one signal: an
/// exponential mean whose cutoff rises with the speed, so that a signal at rest is smooth and a
/// moving one is not late. The result lies between the last result and the new value, so there is
/// no overshoot. Samples need not be evenly spaced in time.
class OneEuro {
 public:
  /// The filtered value at `seconds`, later than the last. After a gap of more than kHoldSeconds
  /// the filter begins again with `value`.
  [[nodiscard]] double next(double seconds, double value, const OneEuroSettings& settings);

 private:
  bool begun_ = false;
  double seconds_ = 0;
  double value_ = 0;  ///< filtered
  double speed_ = 0;  ///< per second, filtered
};

/// One filter for each signal.
class OneEuroBank {
 public:
  /// Filters the signals in place. A signal without data stays so, and its filter waits for the
  /// next value.
  void apply(double seconds, Signals& signals, const OneEuroSettings& settings);

 private:
  std::array<OneEuro, kChannels> filters_;
};

}  // namespace aucast::sources
