#pragma once

#include <deque>
#include <optional>

#include "common/sources/live_timeline.h"
#include "common/time.h"

namespace aucast::sources {

/// Keyframes of a live source on their way out. They go out at once, even after the source has
/// hung, unless the source's clock gets more than kLeadSeconds ahead of ours. Then somebody is
/// feeding in a recording, which is played at its own speed.
class LiveQueue {
 public:
  static constexpr double kLeadSeconds = 1;

  void push(LiveKeyframe keyframe, SteadySeconds now);
  /// The next keyframe, if it is due.
  [[nodiscard]] std::optional<LiveKeyframe> pop(SteadySeconds now);
  /// When pop() will return a keyframe; nullopt while the queue is empty.
  [[nodiscard]] std::optional<double> due() const;
  [[nodiscard]] std::size_t size() const { return queue_.size(); }
  /// Keeps only the latest keyframe, which becomes due at once.
  void skip_to_last(SteadySeconds now);

 private:
  struct Waiting {
    LiveKeyframe keyframe;
    double due = 0;
  };
  std::deque<Waiting> queue_;
  double begin_ = 0;         ///< the time on our clock when the source's was 0
  double last_seconds_ = 0;  ///< of the latest keyframe, on the source's clock
};

}  // namespace aucast::sources
