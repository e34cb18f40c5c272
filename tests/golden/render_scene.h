#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/app/video/face_scene.h"
#include "client/face/face.h"
#include "client/face/face_deformer.h"
#include "client/view/scene.h"
#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::test {

/// A head of spheres that needs no file: skin, two eyes, teeth, a mouth, hair with a clear edge, a
/// collar and brows, so that every kind of shading is in the picture.
class SphereHead {
 public:
  SphereHead();
  [[nodiscard]] view::StaticMesh static_mesh() const;
  [[nodiscard]] view::MovingMesh moving_mesh() const;

 private:
  struct Ball {
    face::Material material = face::Material::Skin;
    glm::vec3 centre{0};
    glm::vec3 radii{1};
    glm::vec4 colour{1};
    /// Which of the ball's kRows rows are there, counted from its top.
    int row_begin = 0;
    int row_end = 0;
    bool clear_edge = false;
    int eye = -1;
  };
  void add(const Ball& ball);

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<glm::vec4> colours_;
  std::vector<float> occlusion_;
  std::vector<float> gloss_;
  std::vector<view::MaterialRange> ranges_;
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
  std::vector<glm::vec3> eye_centres_;
  std::vector<glm::vec3> eye_forward_;
};

/// A face folder as the renderer sees it.
class PosedFace {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PosedFace>> load(
      const std::filesystem::path& folder, const std::filesystem::path& data_folder);

  /// Deforms by the maximum mixer, without rules.
  void pose(const AuFrame& aus);
  [[nodiscard]] view::StaticMesh static_mesh() const;
  [[nodiscard]] view::MovingMesh moving_mesh() const;
  [[nodiscard]] const face::Face& face() const { return face_; }

 private:
  explicit PosedFace(face::Face face);

  face::Face face_;
  app::FaceScene scene_;
  face::FaceDeformer deformer_;
  const face::DeformedFace* deformed_;
  std::vector<float> activations_;
};

}  // namespace aucast::test
