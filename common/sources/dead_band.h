#pragma once

#include "common/action_unit.h"
#include "common/sources/per_au.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// Suppresses a recogniser's noise: an intensity stays as it was until it has changed by the
/// percent of its AU or more, and then takes its exact value. So it is off by at most that percent
/// less one, and 0 is always taken at once. A percent of 0 or 1 changes nothing.
class DeadBand {
 public:
  /// `percent`: whole ones.
  explicit DeadBand(const PerAu& percent) : percent_(percent) {}

  /// The frame to be shown instead of the next one.
  [[nodiscard]] AuFrame settle(const AuFrame& frame);
  /// From the next frame on.
  void change(const PerAu& percent) { percent_ = percent; }

 private:
  PerAu percent_;
  AuFrame shown_;
};

/// The same for a whole stream; as many keyframes, with their times.
void apply_dead_band(protocol::StreamFile& stream, const PerAu& percent);

}  // namespace aucast::sources
