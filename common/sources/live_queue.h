#pragma once

#include <deque>
#include <optional>

#include "common/sources/live_timeline.h"
#include "common/time.h"

namespace aucast::sources {

/// Keyframes of a live source on their way out. They go out at once, even after the source has
/// hung, unless the source's clock gets more than kLead ahead of ours. Then somebody is feeding in
/// a recording, which is played at its own speed.
class LiveQueue {
 public:
  static constexpr Seconds kLead{1};

  void push(LiveKeyframe keyframe, SteadyTime now);
  /// The next keyframe, if it is due.
  [[nodiscard]] std::optional<LiveKeyframe> pop(SteadyTime now);
  /// When pop() will return a keyframe; nullopt while the queue is empty.
  [[nodiscard]] std::optional<SteadyTime> due() const;
  [[nodiscard]] std::size_t size() const { return queue_.size(); }
  /// Keeps only the latest keyframe, which becomes due at once.
  void skip_to_last(SteadyTime now);

 private:
  struct Waiting {
    LiveKeyframe keyframe;
    SteadyTime due;
  };
  std::deque<Waiting> queue_;
  SteadyTime begin_;  ///< the time on our clock when the source's was 0
  Seconds last_{0};   ///< of the latest keyframe, on the source's clock
};

}  // namespace aucast::sources
