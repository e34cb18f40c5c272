#pragma once

#include <optional>

#include "common/time.h"

namespace aucast::server {

/// Finds when something began that is made steadily but arrives with jitter, such as sound from a
/// pipe. A late arrival tells nothing, since it may have waited; an early one shows how late the
/// others were. Follows clocks that differ a little; if arrivals stay late for long, something was
/// lost. Thread: none of its own.
class SlowLine {
 public:
  /// Call when, at `now`, the first `made` of it has arrived. Neither may ever decrease.
  void add(SteadyTime now, Seconds made);
  /// When it began. Only if known().
  [[nodiscard]] SteadyTime begin() const { return *begin_; }
  [[nodiscard]] bool known() const { return begin_.has_value(); }
  /// What comes next does not continue what came: begins again.
  void forget() { *this = {}; }

 private:
  std::optional<SteadyTime> begin_;
  std::optional<SteadyTime> late_since_;
  SteadyTime last_now_;
};

}  // namespace aucast::server
