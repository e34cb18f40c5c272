#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace aucast::face {

/// What a part of the face is made of. A crease is a line on the skin that is invisible until its
/// channel is active.
enum class Material : std::uint8_t {
  Skin,
  Eye,
  Teeth,
  Mouth,
  Hair,
  GreyHair,
  Cloth,
  Brow,
  Lash,
  Crease,
};
/// The names in mesh files, in the order of Material.
inline constexpr std::array<std::string_view, 10> kMaterialNames = {
    "skin", "eye", "teeth", "mouth", "hair", "grey_hair", "cloth", "brow", "lash", "crease"};

/// The name in mesh files.
[[nodiscard]] inline std::string_view name(Material material) {
  return kMaterialNames[static_cast<std::size_t>(material)];
}

/// A named run of vertices and triangles: skin, left_eye, upper_teeth, ... `skin` comes first.
struct MeshPart {
  std::string name;
  Material material = Material::Skin;
  std::uint32_t vertex_begin = 0;
  std::uint32_t vertex_count = 0;
  std::uint32_t triangle_begin = 0;
  std::uint32_t triangle_count = 0;
};

/// Whether the part is drawn, and moved by FaceDeformer, only while its channel is active.
[[nodiscard]] inline bool is_crease(const MeshPart& part) {
  return part.material == Material::Crease;
}

/// The neutral face: one vertex array over all parts, in the order of the face's file.
/// Units and axes: data/faces/README.md (y up, z to the viewer, +x the subject's left, 1 = 1.4
/// cm).
struct FaceMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
  std::vector<MeshPart> parts;
  std::vector<glm::vec4> colours;  ///< linear RGB and alpha in [0,1], one per vertex
  std::vector<float> occlusion;    ///< share of the ambient light that gets there, [0,1]
  std::vector<float> gloss;        ///< factor for the material's highlight
  /// Weights by name, one per vertex: jaw, head, lid_angle, muscle and others, and the masks that
  /// muscles name.
  std::map<std::string, std::vector<float>> maps;
};

/// The map of that name; null if the mesh has none.
[[nodiscard]] inline const std::vector<float>* find_map(const FaceMesh& mesh,
                                                        const std::string& name) {
  const auto found = mesh.maps.find(name);
  return found == mesh.maps.end() ? nullptr : &found->second;
}

/// The vertex's weight in the map that find_map() returned; `missing` if that was null.
[[nodiscard]] inline float map_at(const std::vector<float>* map, std::size_t vertex,
                                  float missing) {
  return map == nullptr ? missing : (*map)[vertex];
}

}  // namespace aucast::face
