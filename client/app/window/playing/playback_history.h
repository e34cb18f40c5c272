#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/gui_model.h"
#include "client/playback/keyframe_source.h"
#include "common/action_unit.h"
#include "common/time.h"

namespace aucast::app {

/// What happened in the last half minute, for the plots and rates of the panel: samples four times
/// a second. Pure; the times handed in must not go back.
class PlaybackHistory {
 public:
  /// True when the next sample is due.
  [[nodiscard]] bool due(Instant now) const;
  /// Takes one: `fill` of the receiver in [0,1], and the AUs as they are on the face.
  void add(Instant now, float fill, const playback::SourceStatus& status, const AuFrame& aus);
  void clear();

  /// Oldest first.
  [[nodiscard]] std::vector<float> fills() const;
  /// The AUs that were strongest, in the order of their numbers; at most gui::kTracesMax.
  [[nodiscard]] std::vector<gui::AuTrace> traces() const;
  /// Bytes a second.
  struct Rates {
    double in = 0;
    double out = 0;
  };
  /// Over the last two seconds.
  [[nodiscard]] Rates rates() const;
  /// Of all bytes, from the first sample to the last; 0 with less than two.
  [[nodiscard]] Rates mean_rates() const;

 private:
  struct Sample {
    Instant slot;  ///< where it stands in the plots, which are even in time
    Instant at;
    float fill = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::map<int, float> aus;  ///< the stronger side of those that are not 0
  };
  std::vector<Sample> samples_;
  std::optional<Instant> begin_;  ///< of the first sample since clear()
};

}  // namespace aucast::app
