#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/time.h"
#include "protocol/packet.h"

namespace aucast::sources {

/// Turns what a live stream serves into the lines of a stream file of the same length: the
/// keyframes as they are and, before one that came after a pause, the face that was held meanwhile,
/// with its time. Pure.
class RecordTimeline {
 public:
  /// The keyframe that is served at `now`, in seconds of any steady clock. `free`: the source's own
  /// clock does not tie it to the previous one, so that there may have been a pause; otherwise a
  /// late keyframe is only late.
  [[nodiscard]] std::vector<protocol::Keyframe> add(const protocol::Keyframe& keyframe,
                                                    SteadySeconds now, bool free);
  /// The stream ended for the clients: the time until it goes on is not kept.
  void end() { begin_.reset(); }

 private:
  std::optional<double> begin_;  ///< when the stream began, or went on after an end
  std::uint64_t place_ms_ = 0;   ///< of the last keyframe's end, since then
  std::vector<AuTerm> shown_;
};

}  // namespace aucast::sources
