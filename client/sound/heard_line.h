#pragma once

#include <deque>
#include <optional>

#include "common/time.h"

namespace aucast::sound {

/// Makes an even clock out of a sound device. Devices report how much of their sound has been
/// heard, but in leaps, some 30 ms too early or too late; a line through the reports of the last
/// second runs evenly. The clock never goes back.
/// Thread: none of its own.
class HeardLine {
 public:
  /// The device reports at `now` that `heard` of its sound has been heard.
  void add(Instant now, Duration heard);
  /// How much has been heard at `now`. The times must not go back.
  [[nodiscard]] Duration at(Instant now);
  /// The device has stopped: at() stays the same until the device reports more than it last did.
  void begin_again();
  /// What the device's clock gains on the steady clock, in parts per million; nullopt until it has
  /// run for 12 seconds.
  [[nodiscard]] std::optional<double> drift_ppm() const;

 private:
  struct Reading {
    Instant at;
    Duration ahead;  ///< how far the device is ahead of the steady clock, both counted from begin_
  };

  [[nodiscard]] Duration mean() const;

  std::deque<Reading> readings_;
  Duration sum_{0};
  Duration said_{0};  ///< the device's last report
  Duration stood_{0};
  Instant begin_{};  ///< what `ahead` is counted from
  Instant last_at_{};
  Duration ahead_{0};                  ///< how far the line is ahead, counted as in Reading
  Duration last_{0};                   ///< what at() returned last
  std::optional<Reading> drift_from_;  ///< a point of the line after it had settled
};

}  // namespace aucast::sound
