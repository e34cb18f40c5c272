#include "client/pipeline/face_pipeline.h"

namespace aucast::pipeline {

FacePipeline::FacePipeline(const AuMapping& mapping, playback::Interpolation interpolation)
    : mapping_(mapping), interpolation_(interpolation), start_(neutral()), end_(neutral()) {
  fired_.reserve(2 * mapping.rules.rules.size());
}

FaceState FacePipeline::neutral() const {
  return {{}, std::vector<float>(mapping_.face.channels.size())};
}

void FacePipeline::begin_keyframe(const AuFrame& aus, const FaceState& start) {
  received_ = aus;
  start_ = start;
  remake();
}

void FacePipeline::remake() {
  fired_.clear();
  end_.aus = mapping_.apply(received_, end_.activations, &fired_);
}

void FacePipeline::change_face() {
  for (FaceState* state : {&start_, &end_}) {
    state->activations.assign(mapping_.face.channels.size(), 0.0F);
  }
  face::mix(mapping_.face.channels, mapping_.recordings, start_.aus, mapping_.mixer,
            start_.activations);
  remake();
}

void FacePipeline::at(double mu, FaceState& state) const {
  const float weight = playback::ease(interpolation_, mu);
  playback::interpolate(start_.aus.left, end_.aus.left, weight, state.aus.left);
  playback::interpolate(start_.aus.right, end_.aus.right, weight, state.aus.right);
  playback::interpolate(start_.activations, end_.activations, weight, state.activations);
}

}  // namespace aucast::pipeline
