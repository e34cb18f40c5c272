#pragma once

#include <string>

#include "common/time.h"

namespace aucast::app {

/// Measures how the time from the start of the program to its first picture was spent.
class StartTimes {
 public:
  /// Begins with the time from the program's start up to this call.
  StartTimes();
  /// Call it when `stage` has ended. The stage took the time since the previous call.
  void passed(const char* stage);
  /// "first picture after 612 ms: files 45, window 220, ..."
  [[nodiscard]] std::string text() const;

 private:
  double total_ms_;
  Instant last_;
  std::string stages_;
};

}  // namespace aucast::app
