#include "client/pipeline/face_delay.h"

#include <cstddef>

#include "common/check.h"

namespace aucast::pipeline {

void FaceDelay::add(Instant at, const std::vector<float>& activations) {
  if (!faces_.empty() && faces_.back().at >= at) faces_.pop_back();
  faces_.push_back({at, activations});
}

void FaceDelay::forget_before(Instant at) {
  while (faces_.size() > 1 && faces_[1].at <= at) faces_.pop_front();
}

const std::vector<float>& FaceDelay::at(Instant at) {
  AUCAST_CHECK(!faces_.empty());
  forget_before(at);
  const Face& before = faces_.front();
  if (faces_.size() == 1 || at <= before.at) return before.activations;
  const Face& after = faces_[1];
  const auto part = static_cast<float>(seconds(at - before.at) / seconds(after.at - before.at));
  between_.resize(before.activations.size());
  for (std::size_t i = 0; i < between_.size(); ++i) {
    between_[i] = before.activations[i] + part * (after.activations[i] - before.activations[i]);
  }
  return between_;
}

}  // namespace aucast::pipeline
