#include "client/glb/surfaces.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "client/face/drawn_blocks.h"

namespace aucast::glb {
namespace {

// Mesh units that a line lies above the skin: creases sink into flat pieces of it, brows hardly.
constexpr float kCreaseLift = 0.05F;
constexpr float kBrowLift = 0.035F;

Look look_of(face::Material material) {
  switch (material) {
    case face::Material::Skin:
      break;
    case face::Material::Eye:
      return Look::Eye;
    case face::Material::Teeth:
    case face::Material::Mouth:
      return Look::Mouth;
    case face::Material::Hair:
      return Look::Hair;
    case face::Material::GreyHair:
      return Look::GreyHair;
    case face::Material::Cloth:
      return Look::Cloth;
    case face::Material::Brow:
    case face::Material::Lash:
      return Look::Brows;
    case face::Material::Crease:
      return Look::Creases;
  }
  return Look::Skin;
}

std::string name_of(const face::MeshPart& part) {
  switch (look_of(part.material)) {
    case Look::Skin:
      return "skin";
    case Look::Mouth:
      return "mouth";
    case Look::Brows:
      return "brows";
    case Look::Creases:
      return "creases";
    case Look::Eye:
      return part.name + "ball";  // the joint has the part's name
    case Look::Hair:
    case Look::GreyHair:
      return "hair";
    case Look::Cloth:
      break;
  }
  return "clothes";
}

void add_part(const face::FaceMesh& mesh, const face::MeshPart& part, Surface& surface) {
  const auto first = static_cast<std::uint32_t>(surface.vertices.size());
  for (std::uint32_t i = 0; i < part.vertex_count; ++i) {
    surface.vertices.push_back(part.vertex_begin + i);
  }
  for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
    auto triangle = mesh.triangles[part.triangle_begin + i];
    for (std::uint32_t& corner : triangle) corner += first - part.vertex_begin;
    surface.triangles.push_back(triangle);
  }
}

}  // namespace

std::vector<Surface> surfaces_of(const face::Face& face) {
  std::vector<Surface> surfaces;
  std::uint32_t creases = 0;
  for (const face::MeshPart& part : face.mesh.parts) {
    const std::uint32_t crease = face::is_crease(part) ? creases++ : 0;
    if (part.vertex_count == 0 || part.triangle_count == 0) continue;
    const std::string name = name_of(part);
    const Look look = look_of(part.material);
    auto surface = std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface& one) {
      return one.look == look && one.name == name;
    });
    if (surface == surfaces.end()) {
      surface = surfaces.insert(surfaces.end(), {name, look, {}, {}, {}});
    }
    add_part(face.mesh, part, *surface);
    if (face::is_crease(part)) surface->creases.resize(surface->vertices.size(), crease);
  }
  return surfaces;
}

std::vector<glm::vec4> colours_of(const face::Face& face, const Surface& surface) {
  std::vector<glm::vec4> colours;
  if (surface.look == Look::Creases) {
    const std::vector<float> kept = face::kept_depths(face);
    const std::vector<float> darkness = darkness_of(face, surface);
    for (std::size_t i = 0; i < darkness.size(); ++i) {
      colours.emplace_back(0, 0, 0, kept[surface.creases[i]] * darkness[i]);
    }
    return colours;
  }
  for (const std::uint32_t i : surface.vertices) {
    const glm::vec4& own = face.mesh.colours[i];
    // As the key light takes it: light from all sides is the viewer's own.
    const float light = 0.42F + 0.58F * face.mesh.occlusion[i];
    colours.emplace_back(light * glm::vec3(own), own.a);
  }
  return colours;
}

std::vector<float> darkness_of(const face::Face& face, const Surface& surface) {
  std::vector<float> darkness;
  for (const std::uint32_t i : surface.vertices) {
    const glm::vec4& own = face.mesh.colours[i];
    darkness.push_back(own.a * (1 - (own.r + own.g + own.b) / 3));
  }
  return darkness;
}

std::vector<glm::vec3> normals_of(const face::Face& face, const Surface& surface) {
  std::vector<glm::vec3> normals(surface.vertices.size(), glm::vec3(0));
  const auto at = [&](std::uint32_t i) { return face.mesh.positions[surface.vertices[i]]; };
  for (const auto& [a, b, c] : surface.triangles) {
    const glm::vec3 normal = glm::cross(at(b) - at(a), at(c) - at(a));
    for (const std::uint32_t i : {a, b, c}) normals[i] += normal;
  }
  for (glm::vec3& normal : normals) {
    const float length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::vec3(0, 0, 1);
  }
  return normals;
}

std::vector<glm::vec3> positions_of(const face::Face& face, const Surface& surface) {
  std::vector<glm::vec3> positions;
  for (const std::uint32_t i : surface.vertices) positions.push_back(face.mesh.positions[i]);
  const float lift = surface.look == Look::Creases ? kCreaseLift
                     : surface.look == Look::Brows ? kBrowLift
                                                   : 0;
  if (lift == 0) return positions;
  const std::vector<glm::vec3> normals = normals_of(face, surface);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    // Lines are seen from both sides, and some are wound the other way.
    const bool outward = normals[i].x * positions[i].x + normals[i].z * positions[i].z >= 0;
    positions[i] += (outward ? lift : -lift) * normals[i];
  }
  return positions;
}

}  // namespace aucast::glb
