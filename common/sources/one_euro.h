#pragma once

#include <array>

#include "common/sources/signals.h"

namespace aucast::sources {

/// What the One Euro filter goes by. Signals are intensities, 1 is full: a smile that comes in half
/// a second has a speed of 2 a second.
struct OneEuroSettings {
  double min_cutoff_hz = 1;         ///< of what stands still, (0, 100]
  double beta = 5;                  ///< Hz that the cutoff rises by at a speed of 1, [0, 100]
  double derivative_cutoff_hz = 1;  ///< of the speed, (0, 100]
  friend bool operator==(const OneEuroSettings&, const OneEuroSettings&) = default;
};

/// G. Casiez, N. Roussel, D. Vogel, "1 Euro filter", CHI 2012, algorithm 1, for one signal: an
/// exponential mean whose cutoff rises with the speed, so that what stands still is smooth and what
/// moves is not late. The result lies between the last one and the new value; there is no
/// overshoot. Steps may differ: each goes by its own time.
class OneEuro {
 public:
  /// The filtered value at `seconds`, later than the last. After a gap of more than kHoldSeconds
  /// what came before says nothing any more: it begins anew with `value`.
  [[nodiscard]] double next(double seconds, double value, const OneEuroSettings& settings);

 private:
  bool begun_ = false;
  double seconds_ = 0;
  double value_ = 0;  ///< filtered
  double speed_ = 0;  ///< a second, filtered
};

/// One for each signal.
class OneEuroBank {
 public:
  /// What has no data stays so, and its filter waits for its next value.
  void apply(double seconds, Signals& signals, const OneEuroSettings& settings);

 private:
  std::array<OneEuro, kChannels> filters_;
};

}  // namespace aucast::sources
