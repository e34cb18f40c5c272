#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "common/action_unit.h"
#include "common/sources/conditioning.h"
#include "common/sources/hold.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// The latest data of every channel (an AU on a side) and when it came.
class Channels {
 public:
  /// Takes what `update` has; a negative intensity is no data.
  void take(double seconds, const AuFrame& update);
  /// The face at that time: a channel that has no data any more holds, then eases to neutral.
  [[nodiscard]] AuFrame at(double seconds) const;

 private:
  AuFrame values_;
  std::array<double, kAuCount> left_seen_{};
  std::array<double, kAuCount> right_seen_{};
};

/// Rows on the source's clock become keyframes. Durations are differences of places rounded to
/// whole milliseconds, so that nothing drifts. A channel (an AU on a side) without data holds, then
/// eases to neutral; where whole rows are missing, keyframes are inserted for that. Samples go
/// through a Conditioning first.
class Timeline {
 public:
  explicit Timeline(const ConditioningSettings& settings = {}) : conditioning_(settings) {}

  /// Takes a sample: the intensities of `update` where it is not negative, the rest has no data.
  /// `seconds` from the first sample on, ascending; false when it falls into the same millisecond
  /// as the last one and is left out.
  bool add(double seconds, const AuFrame& update);

  /// The keyframes. The first one takes the usual time between two.
  [[nodiscard]] protocol::StreamFile finish();

 private:
  void bridge(double until);
  void store(double seconds);

  Conditioning conditioning_;
  Channels channels_;
  protocol::StreamFile stream_;
  std::optional<double> last_seconds_;
  double usual_seconds_ = 0.04;  ///< between the last two samples
  std::int64_t last_ms_ = 0;
};

/// How much of a value is left when its data is `age` seconds old: 1, then less, then 0.
[[nodiscard]] double remaining(double age);

}  // namespace aucast::sources
