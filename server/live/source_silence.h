#pragma once

#include <optional>
#include <utility>

#include "common/time.h"

namespace aucast::server {

/// Decides what follows when nothing comes for a live stream: the silence is logged as soon as the
/// face is no longer held (sources::kHoldSeconds), and the stream is over after the time-out. Where
/// nothing can come any more, it is over as soon as the face is neutral, if that is earlier.
/// Thread: none of its own.
class SourceSilence {
 public:
  /// `time_out` 0: the stream is never over.
  explicit SourceSilence(Milliseconds time_out) : time_out_(time_out) {}

  /// Call it when something comes. Returns whether its coming is to be logged: it is the first
  /// thing to come, or it ends a silence that was logged.
  [[nodiscard]] bool broken() { return std::exchange(said_, false); }
  /// `is_final`: whether nothing can come any more.
  void set_final(bool is_final) { final_ = is_final; }
  [[nodiscard]] bool is_final() const { return final_; }

  /// Whether the silence since `since` is to be logged now; true only once in each silence.
  [[nodiscard]] bool to_be_said(SteadyTime since, SteadyTime now);
  /// Whether a silence can end the stream at all.
  [[nodiscard]] bool ends() const { return time_out_.count() > 0; }
  /// After how long a silence ends the stream.
  [[nodiscard]] Seconds patience() const;
  /// Whether a silence since `since` has ended the stream.
  [[nodiscard]] bool is_over(SteadyTime since, SteadyTime now) const {
    return ends() && now - since >= patience();
  }
  /// When to_be_said() or is_over() next becomes true of a silence since `since`; nullopt: never.
  /// `ended`: the stream has ended already.
  [[nodiscard]] std::optional<SteadyTime> next(SteadyTime since, bool ended) const;

 private:
  Milliseconds time_out_;
  bool said_ = true;  ///< true at first: a silence before the first keyframe is not logged
  bool final_ = false;
};

}  // namespace aucast::server
