#pragma once

#include <optional>
#include <utility>

#include "common/time.h"

namespace aucast::server {

/// What it means for a live stream that nothing comes: once the face is no longer held
/// (sources::kHoldSeconds) that is to be said, and after the time-out the stream is over. Where
/// nothing can come any more it is over as soon as the face is neutral.
/// Thread: none of its own.
class SourceSilence {
 public:
  /// `time_out` 0: the stream is never over.
  explicit SourceSilence(Milliseconds time_out) : time_out_(time_out) {}

  /// Something comes. True when that is to be said: it is the first, or the silence was said.
  [[nodiscard]] bool broken() { return std::exchange(said_, false); }
  /// Whether nothing can come any more.
  void set_final(bool is_final) { final_ = is_final; }
  [[nodiscard]] bool is_final() const { return final_; }

  /// Whether the silence since then is to be said, which is once.
  [[nodiscard]] bool to_be_said(SteadyTime since, SteadyTime now);
  /// Whether a silence can end the stream at all.
  [[nodiscard]] bool ends() const { return time_out_.count() > 0; }
  /// How long a silence may be.
  [[nodiscard]] Seconds patience() const;
  /// Whether the silence since then has ended the stream.
  [[nodiscard]] bool is_over(SteadyTime since, SteadyTime now) const {
    return ends() && now - since >= patience();
  }
  /// When one of these becomes true of a silence since then; nothing: never. `ended`: the stream
  /// has ended already.
  [[nodiscard]] std::optional<SteadyTime> next(SteadyTime since, bool ended) const;

 private:
  Milliseconds time_out_;
  bool said_ = true;  ///< before the first keyframe a silence is nothing to speak of
  bool final_ = false;
};

}  // namespace aucast::server
