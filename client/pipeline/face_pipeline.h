#pragma once

#include <optional>
#include <vector>

#include "client/face/au_blender.h"
#include "client/face/face.h"
#include "client/face/muscle_mixer.h"
#include "client/playback/interpolator.h"

namespace aucast::pipeline {

struct PipelineOptions {
  face::Mixer mixer = face::Mixer::Maximum;
  playback::Interpolation interpolation = playback::Interpolation::Linear;
};

/// The one place that fixes the order from a set of AUs to activations: blend (rules), mix, then in
/// between start and end frame interpolate. Deforming is the caller's, with a FaceDeformer, because
/// not every position is drawn.
/// The face and the rules must outlive it. Nothing is allocated after construction.
/// Thread: the player's.
class FacePipeline {
 public:
  FacePipeline(const face::Face& face, const face::RuleSet& rules, PipelineOptions options);

  /// A keyframe begins: the face as at() gave it last becomes the start frame. That is exactly the
  /// end frame of the one before after at(1).
  void begin_keyframe(const AuFrame& aus);
  /// The activations at fraction `mu` in [0,1] of the current keyframe; neutral before the first.
  /// What is returned stays the same object and is overwritten by the next call.
  [[nodiscard]] const std::vector<float>& at(double mu);

  [[nodiscard]] const AuFrame& received() const { return received_; }
  [[nodiscard]] const AuFrame& blended() const { return blended_; }
  /// The mixer counts from the next keyframe on, the interpolation at once.
  void set_options(PipelineOptions options) { options_ = options; }

 private:
  const face::Face& face_;
  const face::RuleSet& rules_;
  PipelineOptions options_;
  AuFrame received_;
  AuFrame blended_;
  std::vector<float> start_;  ///< one activation per channel of the face, like the next two
  std::vector<float> end_;
  std::vector<float> current_;
};

}  // namespace aucast::pipeline
