#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "client/face/face_deformer.h"
#include "client/glb/face_rig.h"
#include "client/glb/morph_targets.h"
#include "client/pipeline/au_mapping.h"

namespace aucast::glb {

/// Measures how far the exported face, which targets and joints move, is from our own. For each
/// pose that is added, it keeps the largest distance between a drawn vertex and the position that
/// the deformer gives that vertex.
class Drift {
 public:
  /// The arguments must outlive it.
  Drift(const face::Face& face, const MorphTargets& targets, const FaceRig& rig);

  /// Measures one pose, with weights of 8 bits as in the file.
  void add(const pipeline::FaceState& state);

  struct Summary {
    std::size_t faces = 0;
    double median_mm = 0;
    double most_mm = 0;  ///< nine out of ten poses are below it
    double worst_mm = 0;
  };
  [[nodiscard]] Summary summary() const;

 private:
  /// Where targets and joints put each vertex, mesh units.
  [[nodiscard]] std::vector<glm::vec3> moved(const pipeline::FaceState& state) const;

  const face::Face& face_;
  const MorphTargets& targets_;
  const FaceRig& rig_;
  face::FaceDeformer deformer_;
  std::vector<Carried> carried_;  ///< one per vertex
  std::vector<float> worst_;      ///< mesh units, one per pose
};

/// Adds `count` poses of two to six random AUs, each at 20 to 100 %. The same `seed` gives the same
/// poses.
void add_random_faces(const pipeline::AuMapping& mapping, std::size_t count, std::uint64_t seed,
                      Drift& drift);

}  // namespace aucast::glb
