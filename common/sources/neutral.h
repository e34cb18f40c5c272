#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/sources/signals.h"

namespace aucast::sources {

/// A neutral face that was measured.
struct MeasuredNeutral {
  Signals signals = no_signals();   ///< of the neutral face; no data: not seen
  Signals movement = no_signals();  ///< of each signal, the range of its values without the lowest
                                    ///< and the highest tenth
  double seconds = 0;    ///< how long it was measured: as asked, or the length of the recording
  std::size_t rows = 0;  ///< how many rows had data
};

/// Subtracts the neutral face; a signal for which `neutral` has no data stays as it is.
void take_off(Signals& signals, const Signals& neutral);

/// Measures the median and the movement of each signal, over the first seconds in which a face is
/// seen.
class NeutralMeter {
 public:
  /// `seconds` above 0.
  explicit NeutralMeter(double seconds) : wanted_seconds_(seconds) {}

  /// Takes a sample, later than the last; a sample without any data does not count. Returns false
  /// when the seconds have passed; the meter then takes no more samples.
  bool add(double seconds, const Signals& signals);
  [[nodiscard]] bool done() const { return done_; }
  /// The result of the samples taken so far.
  [[nodiscard]] MeasuredNeutral measured() const;

 private:
  double wanted_seconds_;
  std::optional<double> begin_seconds_;
  std::optional<double> last_seconds_;
  bool done_ = false;
  std::size_t rows_ = 0;
  std::array<std::vector<float>, kChannels> sorted_;
};

}  // namespace aucast::sources
