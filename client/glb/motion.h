#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "client/glb/face_rig.h"
#include "client/glb/morph_targets.h"
#include "client/pipeline/face_pipeline.h"
#include "client/pipeline/idle_face.h"
#include "client/playback/interpolator.h"
#include "client/playback/keyframe_list.h"

namespace aucast::glb {

/// How a stream is sampled.
struct Sampling {
  int fps = 30;
  Milliseconds untimed{250};  ///< the time of keyframes that have none of their own
  playback::Interpolation interpolation = playback::Interpolation::Linear;
  pipeline::IdleOptions idle{};
};

/// How many samples for_each_sample() makes.
[[nodiscard]] std::size_t sample_count(const playback::KeyframeList& keyframes,
                                       const Sampling& sampling);

/// Called for each sample; returns whether to go on.
using AtSample = std::function<bool(double seconds, const pipeline::FaceState& face)>;

/// Calls `at_sample` every 1 / fps seconds, from the neutral face at 0 s to the end of the last
/// keyframe: the same faces as in a video's pictures.
void for_each_sample(const pipeline::AuMapping& mapping, const playback::KeyframeList& keyframes,
                     const Sampling& sampling, const AtSample& at_sample);

/// An animation: the weights and joints at each sample.
struct Motion {
  std::string name;
  std::vector<float> seconds;
  std::vector<std::uint8_t> weights;  ///< of all targets at the first sample, then at the second,
                                      ///< and so on
  std::vector<std::vector<JointPose>> joints;  ///< one per sample
};

}  // namespace aucast::glb
