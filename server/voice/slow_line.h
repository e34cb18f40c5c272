#pragma once

#include <optional>

#include "common/time.h"

namespace aucast::server {

/// Finds when something began that is made steadily but arrives with jitter, such as sound from a
/// pipe. A late arrival tells nothing, since it may have waited; an early one shows how late the
/// others were. Follows clocks that differ a little; if arrivals stay late for long, something was
/// lost. Times are seconds of one clock. Thread: none of its own.
class SlowLine {
 public:
  /// Call when, at `now`, the first `made` seconds have arrived. Neither may ever decrease.
  void add(SteadySeconds now, double made);
  /// When it began, on the clock of `now`. Only if known().
  [[nodiscard]] double begin() const { return *begin_; }
  [[nodiscard]] bool known() const { return begin_.has_value(); }
  /// What comes next does not continue what came: begins again.
  void forget() { *this = {}; }

 private:
  std::optional<double> begin_;
  std::optional<double> late_since_;
  double last_now_ = 0;
};

}  // namespace aucast::server
