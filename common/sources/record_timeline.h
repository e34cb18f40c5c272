#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/time.h"
#include "protocol/packet.h"

namespace aucast::sources {

/// The face that was held during a pause, as keyframes that together take `pause`. No keyframes if
/// it is less than 0.1 s, since a busy machine may be that late.
[[nodiscard]] std::vector<protocol::Keyframe> held_face(const std::vector<AuTerm>& shown,
                                                        Milliseconds pause);

/// Turns the keyframes that a live stream serves into lines of a stream file that takes the same
/// time. The keyframes are kept as they are. Before a keyframe that came after a pause, the face
/// that was shown meanwhile is added, with the length of the pause as its time. Pure.
class RecordTimeline {
 public:
  /// Takes the keyframe that is served at `now` and returns its lines. `free`: no clock of the
  /// source says how long after the previous keyframe this one comes, so there may have been a
  /// pause. Otherwise a late keyframe is only late.
  [[nodiscard]] std::vector<protocol::Keyframe> add(const protocol::Keyframe& keyframe,
                                                    SteadyTime now, bool free);
  /// The stream ended for the clients: the time until it goes on is left out.
  void end() { begin_.reset(); }

 private:
  std::optional<SteadyTime> begin_;  ///< when the stream began, or went on after an end
  Milliseconds place_{0};            ///< of the last keyframe's end, counted from begin_
  std::vector<AuTerm> shown_;
};

}  // namespace aucast::sources
