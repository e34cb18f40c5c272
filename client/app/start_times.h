#pragma once

#include <string>

#include "common/time.h"

namespace aucast::app {

/// How the time from the start of the program to its first picture was spent.
class StartTimes {
 public:
  /// Begins with the time up to this call, of which only the length is known.
  StartTimes();
  /// `stage` is over.
  void passed(const char* stage);
  /// "first picture after 612 ms: files 45, window 220, ..."
  [[nodiscard]] std::string text() const;

 private:
  double total_ms_;
  Instant last_;
  std::string stages_;
};

}  // namespace aucast::app
