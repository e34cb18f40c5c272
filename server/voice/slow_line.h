#pragma once

#include <optional>

#include "common/time.h"

namespace aucast::server {

/// When something began that is made steadily and arrives with a jitter, such as sound from a pipe.
/// What arrives late says nothing, for it may have waited; what arrives early says how late the
/// rest was. Two clocks that differ by a little are followed; what is late for long means that
/// something was lost. Times are seconds of one clock. Thread: none of its own.
class SlowLine {
 public:
  /// At `now` the first `made` seconds of it have arrived. It goes on, so neither ever falls.
  void add(SteadySeconds now, double made);
  /// When it began, on the clock of `now`. Needs an add().
  [[nodiscard]] double begin() const { return *begin_; }
  [[nodiscard]] bool known() const { return begin_.has_value(); }
  /// What comes next does not follow what came.
  void forget() { *this = {}; }

 private:
  std::optional<double> begin_;
  std::optional<double> late_since_;
  double last_now_ = 0;
};

}  // namespace aucast::server
