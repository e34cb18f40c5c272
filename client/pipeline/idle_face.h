#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "client/face/face.h"
#include "client/playback/idle_life.h"

namespace aucast::pipeline {

/// Puts what a face does by itself onto the activations that are shown. What the face has no
/// channel for is left out. The face must outlive it.
class IdleFace {
 public:
  explicit IdleFace(const face::Face& face);

  /// Closes both lids at least so far.
  void blink(float closure, std::span<float> activations) const;

  /// Looks aside from where the eyes look, and lifts the head with the breath: by half a degree of
  /// nodding and 0.7 mm forward.
  void stir(const playback::IdleMoment& moment, std::span<float> activations) const;

 private:
  using Channel = std::optional<std::size_t>;
  struct Eye {
    Channel left;
    Channel right;
    Channel up;
    Channel down;
    float yaw_deg = 0;
    float pitch_deg = 0;
  };

  void shift(const Channel& plus, const Channel& minus, double by,
             std::span<float> activations) const;

  const face::Face& face_;
  Channel left_lid_;
  Channel right_lid_;
  std::vector<Eye> eyes_;
  Channel head_up_;
  Channel head_down_;
  Channel head_forward_;
  Channel head_back_;
};

}  // namespace aucast::pipeline
