#pragma once

#include "common/action_unit.h"
#include "common/sources/per_au.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// A recogniser's noise made still: an intensity stays what it was until it has changed by its AU's
/// percent or more, and is then exactly what it is; nothing is ever off by more than that - 1, and
/// what goes to 0 does so at once. 0 and 1 leave everything as it is.
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
