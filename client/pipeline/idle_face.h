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

/// What a face does by itself.
struct IdleOptions {
  std::optional<std::uint64_t> seed{};            ///< gaze and breath (playback/idle_life.h)
  std::optional<playback::BlinkOptions> blink{};  ///< playback/blinking.h
};

/// Adds what a face does by itself to the activations that are shown. Movements that the face has
/// no channel for are left out. The face must outlive it.
class IdleFace {
 public:
  explicit IdleFace(const face::Face& face);

  /// All of it, at `seconds` of the clock that the options' functions go by.
  void apply(const IdleOptions& options, double seconds, std::span<float> activations) const;

  /// Closes both lids at least so far.
  void blink(float closure, std::span<float> activations) const;

  /// Looks aside from where the eyes look, and lifts the head with the breath: by half a degree of
  /// nodding and 0.7 mm forward.
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
