#pragma once

#include <optional>

#include "common/time.h"

namespace aucast::server {

/// For something that is made steadily but arrives with jitter, such as sound from a pipe: finds
/// when it began. A late arrival proves nothing, since it may have waited; an early one shows how
/// late the others were. Follows a clock that differs a little from ours; if all arrivals are late
/// for long, something was lost, and begin() becomes later. Thread: none of its own.
class SlowLine {
 public:
  /// Call when some of it has arrived. `made`: how much has arrived by `now` since the beginning.
  /// `now` and `made` must never decrease.
  void add(SteadyTime now, Seconds made);
  /// When it began. Only if known().
  [[nodiscard]] SteadyTime begin() const { return *begin_; }
  [[nodiscard]] bool known() const { return begin_.has_value(); }
  /// Begins again. Call it when what comes next does not continue what came.
  void forget() { *this = {}; }

 private:
  std::optional<SteadyTime> begin_;
  std::optional<SteadyTime> late_since_;
  SteadyTime last_now_;
};

}  // namespace aucast::server
