#pragma once

#include "common/action_unit.h"
#include "common/sources/per_au.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// Suppresses a recogniser's noise: an intensity stays as it was until it has changed by at least
/// the percent set for its AU, and then takes its exact value. So what is shown is wrong by less
/// than that percent. An intensity of 0 is always taken at once. A percent of 0 or 1 suppresses
/// nothing.
class DeadBand {
 public:
  /// `percent`: whole numbers.
  explicit DeadBand(const PerAu& percent) : percent_(percent) {}

  /// Takes the next frame and returns the one to be shown instead.
  [[nodiscard]] AuFrame settle(const AuFrame& frame);
  /// Sets the percents from the next frame on.
  void change(const PerAu& percent) { percent_ = percent; }

 private:
  PerAu percent_;
  AuFrame shown_;
};

/// Applies a DeadBand to a whole stream. No keyframe is dropped or changes its time.
void apply_dead_band(protocol::StreamFile& stream, const PerAu& percent);

}  // namespace aucast::sources
