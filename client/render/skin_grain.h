#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"

namespace aucast::render {

/// Details of skin that are finer than its vertices: blotches of colour, and pores that tilt the
/// surface and break up its highlights. Cloth uses them too. It is a small texture, wrapped round
/// the neutral head. Needs a current context as long as it lives.
class SkinGrain {
 public:
  SkinGrain();

  /// The texture coordinates of the vertices of a neutral head; `gloss` is the mesh's.
  [[nodiscard]] static std::vector<glm::vec2> places(std::span<const glm::vec3> rest,
                                                     std::span<const float> gloss);
  void bind(GLenum unit) const;

 private:
  Texture texture_;
};

}  // namespace aucast::render
