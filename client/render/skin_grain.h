#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"

namespace aucast::render {

/// What is too fine for a skin's vertices: blotches of its colour, and pores that tilt it and break
/// up its highlights; cloth has it too. A small texture that is wrapped round the head at rest.
/// Needs a current context.
class SkinGrain {
 public:
  SkinGrain();

  /// The texture coordinates of the vertices of a head at rest.
  [[nodiscard]] static std::vector<glm::vec2> places(std::span<const glm::vec3> rest);
  void bind(GLenum unit) const;

 private:
  Texture texture_;
};

}  // namespace aucast::render
