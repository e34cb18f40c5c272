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

/// What a weight adds to the mesh at rest. Vertices are those of the face's mesh, ascending.
struct Target {
  std::string name;         ///< of the channel, such as jaw, or such as AU12_L
  std::size_t channel = 0;  ///< of a muscle, a lid or the jaw
  int au = 0;               ///< 0: it is a channel's
  Side side = Side::Both;   ///< of the AU
  /// How a lid that turns, or a muscle that ends early, leaves a straight line. Its weight is 4 w
  /// (1 - w), where w is the weight of the channel's own target.
  bool arc = false;
  std::vector<float> pose;  ///< activations at weight 1, one per channel of the face
  std::vector<Change> places;
  std::vector<Change> normals;
  std::vector<float> creases;  ///< how deep they are, one per part that is a crease

  /// Its weight where the channel's own target has `weight`.
  [[nodiscard]] float weight(float weight) const {
    return arc ? 4 * weight * (1 - weight) : weight;
  }
};

/// A face's morph targets. What joints do is not in them (of the jaw only what they leave over),
/// and they leave hair, clothes and eyeballs alone. A target of the middle is made for one side's
/// half (Basis::Aus): two halves are added.
class MorphTargets {
 public:
  MorphTargets(const face::Face& face, Basis basis, const FaceRig& rig);

  [[nodiscard]] std::span<const Target> all() const { return targets_; }
  [[nodiscard]] Basis basis() const { return basis_; }

  /// The weights of a face, 255 is 1, one per target.
  [[nodiscard]] std::vector<std::uint8_t> weights(const face::Face& face,
                                                  const pipeline::FaceState& state) const;

 private:
  Basis basis_;
  std::vector<Target> targets_;
};

/// What one side of an AU does at full intensity, in activations: of channels of the middle half,
/// so that both sides together do what the AU does, unless it shows on one side only.
[[nodiscard]] std::vector<float> side_of_au(const face::Face& face, int number, Side side);

}  // namespace aucast::glb
