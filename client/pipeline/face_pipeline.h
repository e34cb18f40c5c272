#pragma once

#include <span>
#include <vector>

#include "client/pipeline/au_mapping.h"
#include "client/playback/interpolator.h"

namespace aucast::pipeline {

/// A face at one moment.
struct FaceState {
  AuFrame aus;                     ///< after the rules; interpolated as the activations are
  std::vector<float> activations;  ///< one per channel of the face
};

/// Turns a set of AUs into activations: blends (rules), mixes, then interpolates between start and
/// end frame. Only this class decides that order. Deforming the mesh (FaceDeformer) is left to the
/// caller, because not every face that at() gives is drawn. The mapping must outlive it; a change
/// to the mapping takes effect at the next keyframe or remake(). Once constructed, it allocates
/// memory only in neutral() and change_face() and, if the mapping has been given more rules, in
/// begin_keyframe() and remake(). Thread: the player's.
class FacePipeline {
 public:
  FacePipeline(const AuMapping& mapping, playback::Interpolation interpolation);

  /// A keyframe begins: the face goes from `start` to `aus`.
  void begin_keyframe(const AuFrame& aus, const FaceState& start);
  /// Makes the end frame again. Call it when the mapping has changed.
  void remake();
  /// Makes both frames again from their AUs. Call it when the mapping has a new face.
  void change_face();
  /// The face at fraction `mu` in [0,1] of the current keyframe: exactly `start` at 0 and the end
  /// frame at 1; neutral before the first keyframe. `state` must be as large as neutral().
  void at(double mu, FaceState& state) const;
  [[nodiscard]] FaceState neutral() const;

  [[nodiscard]] const AuFrame& received() const { return received_; }
  /// The rules that changed something in this keyframe.
  [[nodiscard]] std::span<const face::RuleFired> fired() const { return fired_; }
  /// Takes effect at once.
  void set_interpolation(playback::Interpolation kind) { interpolation_ = kind; }

 private:
  const AuMapping& mapping_;
  playback::Interpolation interpolation_;
  AuFrame received_;
  FaceState start_;
  FaceState end_;
  std::vector<face::RuleFired> fired_;
};

}  // namespace aucast::pipeline
