#pragma once

#include <deque>
#include <optional>

#include "common/time.h"

namespace aucast::sound {

/// Makes an even clock of a sound device. Devices report in leaps, some 30 ms too early or too
/// late, how much of their sound has been heard; the line through the reports of the last second
/// runs evenly, and never goes back.
/// Thread: none of its own.
class HeardLine {
 public:
  /// The device reports at `now` that `heard` of its sound has been heard.
  void add(Instant now, Duration heard);
  /// How much has been heard at `now`. The times must not go back.
  [[nodiscard]] Duration at(Instant now);
  /// The device has stopped, and the line with it, until it reports more than so far.
  void begin_again();
  /// What the device's clock gains on the steady clock, in parts of a million; nothing before it
  /// has run for ten seconds.
  [[nodiscard]] std::optional<double> drift_ppm() const;

 private:
  struct Reading {
    Instant at;
    Duration ahead;  ///< of the steady clock
  };

  [[nodiscard]] Duration mean() const;

  std::deque<Reading> readings_;
  Duration sum_{0};
  Duration said_{0};  ///< the last reading
  Duration stood_{0};
  Instant begin_{};  ///< what `ahead` is counted from
  Instant last_at_{};
  Duration ahead_{0};                  ///< of the line
  Duration last_{0};                   ///< what at() gave
  std::optional<Reading> drift_from_;  ///< of the line, when it had settled
};

}  // namespace aucast::sound
