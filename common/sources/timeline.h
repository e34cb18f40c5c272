#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "common/action_unit.h"
#include "common/sources/conditioning.h"
#include "common/sources/hold.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// Keeps the latest data of every channel (an AU on a side), and when it came.
class Channels {
 public:
  /// Takes the intensities of `update`; a negative one is no data.
  void take(double seconds, const AuFrame& update);
  /// The face at that time. A channel without new data holds for kHoldSeconds, then eases to
  /// neutral.
  [[nodiscard]] AuFrame at(double seconds) const;

 private:
  AuFrame values_;
  std::array<double, kAuCount> left_seen_seconds_{};
  std::array<double, kAuCount> right_seen_seconds_{};
};

/// Turns the samples of a recording into keyframes. Times are differences of places rounded to
/// whole milliseconds, so that rounding errors do not add up. A channel (an AU on a side) without
/// data holds, then eases to neutral; where whole rows are missing, keyframes are inserted to show
/// this. Samples go through a Conditioning first.
class Timeline {
 public:
  explicit Timeline(const ConditioningSettings& settings = {}) : conditioning_(settings) {}

  /// Takes a sample: the intensities of `update`; a negative one is no data. `seconds` ascend.
  /// Returns false when the sample falls into the same millisecond as the last one and is left out.
  bool add(double seconds, const AuFrame& update);

  /// The keyframes. The first one takes the median of the other durations.
  [[nodiscard]] protocol::StreamFile finish();

 private:
  void bridge(double until_seconds);
  void store(double seconds);
  void keep(double seconds, std::int64_t place_ms);

  Conditioning conditioning_;
  Channels channels_;
  protocol::StreamFile stream_;
  std::optional<double> last_seconds_;
  double usual_seconds_ = 0.04;  ///< between the last two samples
  std::int64_t last_ms_ = 0;
};

/// The share of a value that is left when its data is `age_seconds` old: 1 while the value is held,
/// then less, then 0.
[[nodiscard]] double remaining(double age_seconds);

}  // namespace aucast::sources
