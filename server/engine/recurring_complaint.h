#pragma once

#include <cstdint>
#include <optional>

#include "common/time.h"

namespace aucast::server {

/// A complaint that may recur at every message, and is said once a period. No clock.
/// Thread: none of its own.
class RecurringComplaint {
 public:
  explicit RecurringComplaint(Duration period) : period_(period) {}

  /// Call each time that it happens. Returns how often it has happened so far if it is to be said
  /// now; nullopt if it was said less than a period ago.
  [[nodiscard]] std::optional<std::uint64_t> happened(Instant now) {
    ++times_;
    if (next_ && now < *next_) return std::nullopt;
    next_ = now + period_;
    return times_;
  }

 private:
  Duration period_;
  std::uint64_t times_ = 0;
  std::optional<Instant> next_;  ///< when it may be said again; nullopt: it never was
};

}  // namespace aucast::server
