#include "client/app/video/face_scene.h"

#include <algorithm>
#include <span>

#include "common/check.h"

namespace aucast::app {
namespace {

int eye_of(const face::Face& face, const std::string& part) {
  const auto found = std::find_if(face.eyes.begin(), face.eyes.end(),
                                  [&](const face::Eye& eye) { return eye.part == part; });
  return found == face.eyes.end() ? -1 : static_cast<int>(found - face.eyes.begin());
}

}  // namespace

view::Material look_of(face::Material material) {
  using view::Shader;
  switch (material) {
    case face::Material::Skin:
      return {.order = 2, .two_sided = false, .specular = 0.23F, .power = 26, .grain = 1};
    case face::Material::Eye:
      return {.shader = Shader::Eye, .two_sided = false, .wrap = 0.6F, .power = 60};
    case face::Material::Teeth:
      // Teeth behind a lip are lit through and from all sides; in true shadow they look grey.
      return {.wrap = 1, .specular = 0.5F, .power = 40, .shadow_kept = 0.56F, .enclosed = 0.22F};
    case face::Material::Mouth:
      // Light is lost in the mouth, but not all of it, or it is a hole.
      return {.wrap = 1, .specular = 0.4F, .power = 24, .shadow_kept = 0.34F};
    case face::Material::Hair:
    case face::Material::GreyHair:
      return {.shader = Shader::Hair,
              .order = 0,
              .two_sided = false,
              .wrap = 0.8F,
              .specular = 0.46F,
              .power = 18,
              .grey = material == face::Material::GreyHair ? 1.0F : 0.0F};
    case face::Material::Cloth:
      return {.order = 1, .wrap = 0.7F, .specular = 0.05F, .power = 6, .grain = 1.3F};
    case face::Material::Brow:
      return {.wrap = 0.7F, .specular = 0.05F, .power = 10, .thinning = 1};
    case face::Material::Lash:
      return {.wrap = 0.7F, .specular = 0.05F, .power = 10};
    case face::Material::Crease:
      return {.shader = Shader::Crease};
  }
  AUCAST_CHECK(false);
  return {};
}

FaceScene::FaceScene(const face::Face& face) : face_(face) {
  int creases = 0;
  for (const face::MeshPart& part : face.mesh.parts) {
    view::MaterialRange range;
    range.material = look_of(part.material);
    range.triangle_begin = part.triangle_begin;
    range.triangle_count = part.triangle_count;
    range.eye = eye_of(face, part.name);
    if (face::is_crease(part)) range.crease = creases++;
    // Waters' own mask stays the polygons that he drew.
    range.rounded = !face.classic && part.material == face::Material::Skin;
    const auto colours = std::span(face.mesh.colours).subspan(part.vertex_begin, part.vertex_count);
    range.translucent = std::any_of(colours.begin(), colours.end(),
                                    [](const glm::vec4& colour) { return colour.a < 1.0F; });
    ranges_.push_back(range);
  }
}

view::StaticMesh FaceScene::still() const {
  view::StaticMesh mesh{face_.mesh.triangles, face_.mesh.colours, face_.mesh.occlusion,
                        face_.mesh.gloss, ranges_};
  if (!face_.classic) mesh.rest = face_.mesh.positions;
  const auto strand = face_.mesh.maps.find("strand");
  if (strand != face_.mesh.maps.end()) mesh.strand = strand->second;
  return mesh;
}

view::MovingMesh FaceScene::moving(const face::DeformedFace& deformed) {
  return {deformed.positions,   deformed.normals, deformed.eye_centres,
          deformed.eye_forward, deformed.creases, deformed.eye_open};
}

}  // namespace aucast::app
