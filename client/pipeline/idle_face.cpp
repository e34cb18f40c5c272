#include "client/pipeline/idle_face.h"

#include <algorithm>

namespace aucast::pipeline {
namespace {

constexpr double kBreathNodDeg = 0.5;
constexpr double kBreathForward = 0.05;  // mesh units of 1.4 cm

}  // namespace

IdleFace::IdleFace(const face::Face& face)
    : face_(face),
      left_lid_(face.channel_index("left_lid_close")),
      right_lid_(face.channel_index("right_lid_close")),
      head_pitch_(face::opposed(face, face::kHeadPitch)),
      head_shift_(face::opposed(face, face::kHeadShift)) {
  for (const face::Eye& eye : face.eyes) {
    const Side side = face::side_at(eye.centre.x);
    eyes_.push_back({face::opposed(face, face::kGazeYaw, side),
                     face::opposed(face, face::kGazePitch, side), eye.yaw_deg, eye.pitch_deg});
  }
}

void IdleFace::apply(const IdleOptions& options, double seconds,
                     std::span<float> activations) const {
  if (options.seed) move(playback::idle_motion(*options.seed, seconds), activations);
  if (options.blink) blink(playback::blink_closure(*options.blink, seconds), activations);
}

void IdleFace::blink(float closure, std::span<float> activations) const {
  for (const Channel& lid : {left_lid_, right_lid_}) {
    if (lid) activations[*lid] = std::max(activations[*lid], closure);
  }
}

/// Adds `by` to the difference of two opposed channels. Afterwards at most one of them is active.
void IdleFace::shift(const face::OpposedChannels& channels, double by,
                     std::span<float> activations) const {
  const auto& [plus, minus] = channels;
  if (by == 0 || !plus || !minus) return;
  const float sum = activations[*plus] - activations[*minus] + static_cast<float>(by);
  activations[*plus] = std::clamp(sum, 0.0F, face_.channels[*plus].activation_max);
  activations[*minus] = std::clamp(-sum, 0.0F, face_.channels[*minus].activation_max);
}

void IdleFace::move(const playback::IdleMotion& motion, std::span<float> activations) const {
  for (const Eye& eye : eyes_) {
    if (eye.yaw_deg > 0) {
      shift(eye.yaw, motion.gaze_left_deg / static_cast<double>(eye.yaw_deg), activations);
    }
    if (eye.pitch_deg > 0) {
      shift(eye.pitch, motion.gaze_up_deg / static_cast<double>(eye.pitch_deg), activations);
    }
  }
  if (!face_.head) return;
  if (face_.head->pitch_deg > 0) {
    shift(head_pitch_, motion.breath * kBreathNodDeg / static_cast<double>(face_.head->pitch_deg),
          activations);
  }
  if (face_.head->shift > 0) {
    shift(head_shift_, motion.breath * kBreathForward / static_cast<double>(face_.head->shift),
          activations);
  }
}

}  // namespace aucast::pipeline
