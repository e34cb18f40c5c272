#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "client/face/face_deformer.h"
#include "client/glb/face_rig.h"
#include "client/glb/morph_targets.h"
#include "client/pipeline/au_mapping.h"

namespace aucast::glb {

/// How far targets and joints are from the face itself: for each face that is added, the distance
/// of the drawn vertex that is farthest from where the deformer has it.
class Drift {
 public:
  /// All of them must outlive it.
  Drift(const face::Face& face, const MorphTargets& targets, const FaceRig& rig);

  /// With the weights as the file has them, of 8 bits.
  void add(const pipeline::FaceState& state);

  struct Summary {
    std::size_t faces = 0;
    double median_mm = 0;
    double most_mm = 0;  ///< for nine of ten faces it is less
    double worst_mm = 0;
  };
  [[nodiscard]] Summary summary() const;

 private:
  /// Where file and player would have every vertex.
  [[nodiscard]] std::vector<glm::vec3> placed(const pipeline::FaceState& state) const;

  const face::Face& face_;
  const MorphTargets& targets_;
  const FaceRig& rig_;
  face::FaceDeformer deformer_;
  std::vector<Carried> carried_;  ///< one per vertex
  std::vector<float> worst_;      ///< mesh units, one per face
};

/// Adds `count` faces of two to six random AUs of 20 to 100 %, the same on every run.
void add_random_faces(const pipeline::AuMapping& mapping, std::size_t count, std::uint64_t seed,
                      Drift& drift);

}  // namespace aucast::glb
