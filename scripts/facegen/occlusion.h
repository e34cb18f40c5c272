#pragma once

#include <memory>
#include <span>
#include <vector>

#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// Triangles that rays can hit: a tree of boxes.
class RayScene {
 public:
  explicit RayScene(std::span<const Part* const> parts);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Whether anything lies between `near` and `far` along the unit direction.
  [[nodiscard]] bool hit(const Vec3& origin, const Vec3& direction, double near, double far) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

struct OcclusionOptions {
  int rays = 128;
  double reach = 4.5;     ///< anything further away than this darkens nothing
  double darkest = 0.28;  ///< the light that arrives at the darkest place
  int smoothing = 2;      ///< passes that average each vertex with its neighbours
};

/// Stage 6: stores how much ambient light arrives at each vertex of the part, in the neutral face.
void bake_occlusion(Part& part, const RayScene& occluders, const OcclusionOptions& options);

}  // namespace aucast::facegen
