#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/time.h"
#include "protocol/packet.h"

namespace aucast::sources {

/// What a live stream serves, as the lines of a stream file that takes as long: the keyframes as
/// they are, and before one that came after a pause the face that stood meanwhile, with the time
/// that it stood. Pure.
class RecordTimeline {
 public:
  /// The keyframe that is served at `now`, in seconds of any steady clock. `free`: the source's own
  /// clock does not tie it to the one before, so that there may have been a pause; where it does,
  /// what is late is only late.
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
