#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/face/face.h"
#include "client/face/opposed_channels.h"
#include "client/playback/blinking.h"
#include "client/playback/idle_life.h"

namespace aucast::pipeline {

/// What an idle face does; nullopt: it does not do that.
struct IdleOptions {
  std::optional<std::uint64_t> seed{};            ///< gaze and breath (playback/idle_life.h)
  std::optional<playback::BlinkOptions> blink{};  ///< playback/blinking.h
};

/// Adds the movements of an idle face to the activations that are shown. Movements for which the
/// face has no channel are left out. The face must outlive it.
class IdleFace {
 public:
  explicit IdleFace(const face::Face& face);

  /// Adds all movements that the options ask for, for the time `seconds` >= 0.
  void apply(const IdleOptions& options, double seconds, std::span<float> activations) const;

  /// Closes both lids to `closure`, in [0,1]. A lid that is closed further stays as it is.
  void blink(float closure, std::span<float> activations) const;

  /// Turns the eyes away from where they look. With the breath, nods the head upwards by half a
  /// degree and moves it 0.7 mm forward.
  void move(const playback::IdleMotion& motion, std::span<float> activations) const;

 private:
  using Channel = std::optional<std::size_t>;
  struct Eye {
    face::OpposedChannels yaw;
    face::OpposedChannels pitch;
    float yaw_deg = 0;
    float pitch_deg = 0;
  };

  void shift(const face::OpposedChannels& channels, double by, std::span<float> activations) const;

  const face::Face& face_;
  Channel left_lid_;
  Channel right_lid_;
  std::vector<Eye> eyes_;
  face::OpposedChannels head_pitch_;
  face::OpposedChannels head_shift_;
};

}  // namespace aucast::pipeline
