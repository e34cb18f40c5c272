#pragma once

#include <vector>

#include "client/face/face.h"
#include "client/face/face_deformer.h"
#include "client/view/scene.h"

namespace aucast::app {

/// How the renderer draws a material.
[[nodiscard]] view::Material look_of(face::Material material);

/// A face in the form that the renderer needs. The face must outlive it.
class FaceScene {
 public:
  explicit FaceScene(const face::Face& face);

  [[nodiscard]] view::StaticMesh still() const;
  [[nodiscard]] static view::MovingMesh moving(const face::DeformedFace& deformed);

 private:
  const face::Face& face_;
  std::vector<view::MaterialRange> ranges_;
};

}  // namespace aucast::app
