#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/face/face.h"

namespace aucast::glb {

/// What a surface looks like, as far as glTF can show it.
enum class Look : std::uint8_t { Skin, Mouth, Brows, Creases, Eye, Hair, GreyHair, Cloth };

/// Parts of a face that become one mesh.
struct Surface {
  std::string name;
  Look look = Look::Skin;
  std::vector<std::uint32_t> vertices;                  ///< of the face's mesh, ascending
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< into `vertices`
  std::vector<std::uint32_t> creases;  ///< Look::Creases: for each vertex, the number of its crease

  /// Whether muscles move this surface.
  [[nodiscard]] bool morphs() const {
    return look == Look::Skin || look == Look::Mouth || look == Look::Brows ||
           look == Look::Creases;
  }
  [[nodiscard]] bool hair() const { return look == Look::Hair || look == Look::GreyHair; }
};

/// The surfaces of a face, skin first. Each eyeball is one surface; all other parts are put
/// together by look.
[[nodiscard]] std::vector<Surface> surfaces_of(const face::Face& face);

/// Linear RGB and alpha of each vertex, darker where little light arrives, as in our own renderer.
/// A crease is black, and transparent until its morph target shows it, but for what the skin keeps.
[[nodiscard]] std::vector<glm::vec4> colours_of(const face::Face& face, const Surface& surface);

/// For each of the surface's vertices, how dark its crease is at depth 1.
[[nodiscard]] std::vector<float> darkness_of(const face::Face& face, const Surface& surface);

/// Where the surface's vertices lie at rest. Brows and creases are lifted a little off the skin,
/// whose mesh is coarser and would cover them.
[[nodiscard]] std::vector<glm::vec3> positions_of(const face::Face& face, const Surface& surface);

/// Vertex normals of unit length: the mean over the vertex's triangles, weighted by area.
[[nodiscard]] std::vector<glm::vec3> normals_of(const face::Face& face, const Surface& surface);

}  // namespace aucast::glb
