#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/face/face.h"

namespace aucast::glb {

/// How a surface is made up, as far as glTF goes.
enum class Look : std::uint8_t { Skin, Mouth, Brows, Creases, Eye, Hair, GreyHair, Cloth };

/// Parts of a face that become one mesh.
struct Surface {
  std::string name;
  Look look = Look::Skin;
  std::vector<std::uint32_t> vertices;                  ///< of the face's mesh, ascending
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< into `vertices`
  std::vector<std::uint32_t> creases;  ///< of each vertex of creases: which crease it is of

  /// Muscles move it.
  [[nodiscard]] bool morphs() const {
    return look == Look::Skin || look == Look::Mouth || look == Look::Brows ||
           look == Look::Creases;
  }
  [[nodiscard]] bool hair() const { return look == Look::Hair || look == Look::GreyHair; }
};

/// The surfaces of a face, skin first. Each eyeball is one; others are of a kind of material.
[[nodiscard]] std::vector<Surface> surfaces_of(const face::Face& face);

/// What the surface takes of the light, linear RGB and alpha; less where little light arrives, as
/// our own renderer has it. A crease is black, and clear until its target shows it.
[[nodiscard]] std::vector<glm::vec4> colours_of(const face::Face& face, const Surface& surface);

/// How dark a crease is at depth 1, for each of the surface's vertices.
[[nodiscard]] std::vector<float> darkness_of(const face::Face& face, const Surface& surface);

/// Where its vertices lie at rest: what is drawn on the skin lies a little above it, because the
/// skin beneath is coarser.
[[nodiscard]] std::vector<glm::vec3> places_of(const face::Face& face, const Surface& surface);

/// Normals of the triangles, weighed by their areas, unit length.
[[nodiscard]] std::vector<glm::vec3> normals_of(const face::Face& face, const Surface& surface);

}  // namespace aucast::glb
