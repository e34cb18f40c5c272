#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "common/action_unit.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// A channel without data keeps its last value for so long,
inline constexpr double kHoldSeconds = 0.5;
/// and is then led to neutral in so long.
inline constexpr double kEaseSeconds = 1.0;

/// Rows on the source's clock become keyframes. Durations are differences of places rounded to
/// whole milliseconds, so that nothing drifts. A channel (an AU on a side) without data holds, then
/// eases to neutral; where whole rows are missing, keyframes are put in to do so.
class Timeline {
 public:
  /// Takes a moment: the intensities of `update` where it is not negative, the rest has no data.
  /// `seconds` from the first moment on, ascending; false when it falls into the same millisecond
  /// as the last one and is left out.
  bool add(double seconds, const AuFrame& update);

  /// The keyframes. The first one takes the usual time between two.
  [[nodiscard]] protocol::StreamFile finish();

 private:
  struct Channels {
    AuFrame values;
    std::array<double, kAuCount> left_seen{};
    std::array<double, kAuCount> right_seen{};
  };

  void bridge(double until);
  void store(double seconds);
  [[nodiscard]] AuFrame at(double seconds) const;

  Channels channels_;
  protocol::StreamFile stream_;
  std::optional<double> last_seconds_;
  double usual_seconds_ = 0.04;  ///< between the last two moments
  std::int64_t last_ms_ = 0;
};

/// How much of a value is left when its data is `age` seconds old: 1, then less, then 0.
[[nodiscard]] double remaining(double age);

}  // namespace aucast::sources
