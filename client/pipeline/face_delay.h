#pragma once

#include <deque>
#include <vector>

#include "common/time.h"

namespace aucast::pipeline {

/// Keeps recent faces, so that one can be shown later than it was made, with its sound.
/// Thread: none of its own.
class FaceDelay {
 public:
  /// The face of `at`, one activation per channel. The times must not go back.
  void add(Instant at, const std::vector<float>& activations);
  /// at() will not be asked for anything earlier any more.
  void forget_before(Instant at);
  /// The face at `at`, interpolated between its neighbours; before all faces the first, after all
  /// the last. Earlier faces are forgotten. At least one must have been added. Valid until the next
  /// call.
  [[nodiscard]] const std::vector<float>& at(Instant at);
  [[nodiscard]] bool empty() const { return faces_.empty(); }
  void clear() { faces_.clear(); }

 private:
  struct Face {
    Instant at;
    std::vector<float> activations;
  };

  std::deque<Face> faces_;
  std::vector<float> between_;
};

}  // namespace aucast::pipeline
