#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "client/playback/keyframe_source.h"
#include "common/action_unit.h"
#include "common/time.h"

namespace aucast::app {

/// Samples of the last half minute, four a second, for the plots and rates of the panel. Pure; the
/// times handed in must not go back.
class PlaybackHistory {
 public:
  /// Whether the next sample is due.
  [[nodiscard]] bool due(Instant now) const;
  /// Adds a sample. `fill`: of the Receiver buffer, in [0,1]; `aus`: those on the face.
  void add(Instant now, float fill, const playback::SourceStatus& status, const AuFrame& aus);

  /// The fills of all samples, oldest first.
  [[nodiscard]] std::vector<float> fills() const;
  /// The strongest AUs, at most gui::kTracesMax, sorted by number.
  [[nodiscard]] std::vector<gui::AuTrace> traces() const;
  /// Bytes a second.
  struct Rates {
    double in = 0;
    double out = 0;
  };
  /// The rates over the last two seconds.
  [[nodiscard]] Rates rates() const;
  /// The mean rates from the first sample to the last; 0 with fewer than two samples.
  [[nodiscard]] Rates mean_rates() const;

 private:
  struct Sample {
    Instant slot;  ///< its time in the plots, whose samples are evenly spaced
    Instant at;
    float fill = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::map<int, float> aus;  ///< AUs above 0, by number: the stronger side's intensity
  };
  std::vector<Sample> samples_;
  std::optional<Instant> begin_;  ///< time of the first sample
};

}  // namespace aucast::app
