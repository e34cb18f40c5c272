#include "client/pipeline/face_pipeline.h"

#include <algorithm>

namespace aucast::pipeline {

FacePipeline::FacePipeline(const face::Face& face, const face::RuleSet& rules,
                           PipelineOptions options)
    : face_(face),
      rules_(rules),
      options_(options),
      start_(face.channels.size()),
      end_(face.channels.size()),
      current_(face.channels.size()) {}

void FacePipeline::begin_keyframe(const AuFrame& aus) {
  std::copy(current_.begin(), current_.end(), start_.begin());
  received_ = aus;
  blended_ = face::blend(rules_, received_);
  face::mix(face_, blended_, options_.mixer, end_);
}

const std::vector<float>& FacePipeline::at(double mu) {
  const float weight = playback::ease(options_.interpolation, mu);
  playback::interpolate(start_, end_, weight, current_);
  return current_;
}

}  // namespace aucast::pipeline
