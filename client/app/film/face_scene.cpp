#include "client/app/film/face_scene.h"

#include <algorithm>

#include "common/check.h"

namespace aucast::app {
namespace {

view::Shading shading_of(face::Material material) {
  switch (material) {
    case face::Material::Skin:
      return view::Shading::Skin;
    case face::Material::Eye:
      return view::Shading::Eye;
    case face::Material::Teeth:
      return view::Shading::Teeth;
    case face::Material::Mouth:
      return view::Shading::Mouth;
    case face::Material::Hair:
      return view::Shading::Hair;
    case face::Material::Cloth:
      return view::Shading::Cloth;
    case face::Material::Brow:
      return view::Shading::Brow;
    case face::Material::Crease:
      return view::Shading::Crease;
  }
  AUCAST_CHECK(false);
  return view::Shading::Skin;
}

int eye_of(const face::Face& face, const std::string& part) {
  const auto found = std::find_if(face.eyes.begin(), face.eyes.end(),
                                  [&](const face::Eye& eye) { return eye.part == part; });
  return found == face.eyes.end() ? -1 : static_cast<int>(found - face.eyes.begin());
}

}  // namespace

FaceScene::FaceScene(const face::Face& face) : face_(face) {
  int creases = 0;
  for (const face::MeshPart& part : face.mesh.parts) {
    view::ShadedRange range;
    range.shading = shading_of(part.material);
    range.triangle_begin = part.triangle_begin;
    range.triangle_count = part.triangle_count;
    range.eye = eye_of(face, part.name);
    if (face::is_crease(part)) range.crease = creases++;
    // Waters' own mask stays the polygons that he drew.
    range.rounded = !face.classic && part.material == face::Material::Skin;
    const auto begin = face.mesh.colours.begin() + part.vertex_begin;
    range.translucent = std::any_of(begin, begin + part.vertex_count,
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
