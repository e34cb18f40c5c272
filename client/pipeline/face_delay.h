#pragma once

#include <deque>
#include <vector>

#include "common/time.h"

namespace aucast::pipeline {

/// Keeps recent faces, so that a face can be shown later than it was made, together with its sound.
/// Thread: none of its own.
class FaceDelay {
 public:
  /// Adds the face of the time `at`, one activation per channel. The times must not go back.
  void add(Instant at, const std::vector<float>& activations);
  /// Says that at() will not be asked for any time before `at` from now on.
  void forget_before(Instant at);
  /// The face at `at`, interpolated between its neighbours; the first face if `at` is before it,
  /// the last one if `at` is after it. Earlier faces are forgotten. At least one face must have
  /// been added. Valid until the next call.
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
