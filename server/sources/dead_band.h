#pragma once

#include "common/action_unit.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// A recogniser's noise made still: an intensity stays what it was until it has changed by
/// `percent` or more, and is then exactly what it is; nothing is ever off by more than `percent` -
/// 1, and what goes to 0 does so at once. 0 and 1 leave everything as it is.
class DeadBand {
 public:
  explicit DeadBand(int percent) : percent_(percent) {}

  /// The frame to be shown instead of the next one.
  [[nodiscard]] AuFrame settle(const AuFrame& frame);

 private:
  int percent_;
  AuFrame shown_;
};

/// The same for a whole stream; as many keyframes, with their times.
void apply_dead_band(protocol::StreamFile& stream, int percent);

}  // namespace aucast::sources
