#include "client/glb/motion.h"

#include <algorithm>

namespace aucast::glb {
namespace {

std::int64_t time_ms(const playback::KeyframeList& keyframes, std::size_t index,
                     const Sampling& sampling) {
  return keyframes.time(index).value_or(sampling.untimed).count();
}

}  // namespace

std::size_t sample_count(const playback::KeyframeList& keyframes, const Sampling& sampling) {
  std::int64_t all_ms = 0;
  for (std::size_t i = 0; i < keyframes.size(); ++i) all_ms += time_ms(keyframes, i, sampling);
  return static_cast<std::size_t>(all_ms * sampling.fps / 1000) + 1;
}

void for_each_sample(const pipeline::AuMapping& mapping, const playback::KeyframeList& keyframes,
                     const Sampling& sampling, const AtSample& at_sample) {
  pipeline::FacePipeline pipeline(mapping, sampling.interpolation);
  const pipeline::IdleFace idle(mapping.face);
  pipeline::FaceState reached = pipeline.neutral();
  pipeline::FaceState shown = reached;
  std::int64_t begin_ms = 0;
  std::int64_t next = 0;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    pipeline.begin_keyframe(keyframes.aus(i), reached);
    const std::int64_t takes_ms = time_ms(keyframes, i, sampling);
    for (; next * 1000 <= (begin_ms + takes_ms) * sampling.fps; ++next) {
      const double seconds = static_cast<double>(next) / sampling.fps;
      const double into_ms = 1000 * seconds - static_cast<double>(begin_ms);
      const double mu = takes_ms == 0 ? 1.0 : into_ms / static_cast<double>(takes_ms);
      pipeline.at(std::clamp(mu, 0.0, 1.0), shown);
      idle.apply(sampling.idle, seconds, shown.activations);
      if (!at_sample(seconds, shown)) return;
    }
    pipeline.at(1, reached);
    begin_ms += takes_ms;
  }
}

}  // namespace aucast::glb
