#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "client/face/face.h"
#include "client/glb/basis.h"
#include "client/glb/face_rig.h"
#include "client/glb/glb_file.h"
#include "client/pipeline/face_pipeline.h"

namespace aucast::glb {

/// A morph target: what its weight adds to the mesh at rest. Vertices are numbered as in the face's
/// mesh and ascend.
struct Target {
  std::string name;         ///< a channel's, such as jaw, or an AU's with its side, such as AU12_L
  std::size_t channel = 0;  ///< a muscle, a lid or the jaw; unused if `au` is not 0
  int au = 0;               ///< 0: the target is a channel's
  Side side = Side::Both;   ///< of the AU
  /// True for a second target of a channel, which adds how far vertices leave the straight line
  /// when a lid turns or a muscle reaches its cap. Its weight is 4 w (1 - w), where w is the weight
  /// of the channel's first target.
  bool arc = false;
  std::vector<float> pose;  ///< activations at weight 1, one per channel of the face
  std::vector<Change> positions;
  std::vector<Change> normals;
  std::vector<float> creases;  ///< depths in [0,1], one per part that is a crease

  /// This target's weight when the channel's first target has `weight`.
  [[nodiscard]] float weight(float weight) const {
    return arc ? 4 * weight * (1 - weight) : weight;
  }
};

/// A face's morph targets. They leave out what joints do (for the jaw, they add only what its joint
/// does not do), and never move hair, clothes or eyeballs. With Basis::Aus each target of a side
/// has half of what the AU does to channels in the middle, so that both sides add up to the whole.
class MorphTargets {
 public:
  MorphTargets(const face::Face& face, Basis basis, const FaceRig& rig);

  [[nodiscard]] std::span<const Target> all() const { return targets_; }
  [[nodiscard]] Basis basis() const { return basis_; }

  /// The weights for `state`, one per target; 255 means 1.
  [[nodiscard]] std::vector<std::uint8_t> weights(const face::Face& face,
                                                  const pipeline::FaceState& state) const;

 private:
  Basis basis_;
  std::vector<Target> targets_;
};

/// The activations that one side of an AU asks for at full intensity. Channels in the middle get
/// half, so that both sides together do what the AU does; they get all of it if the AU is one that
/// shows on one side only.
[[nodiscard]] std::vector<float> side_of_au(const face::Face& face, int number, Side side);

}  // namespace aucast::glb
