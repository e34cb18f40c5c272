#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"

namespace aucast::render {

/// What is too fine for the vertices of a skin: an even grain of its colour and pores that break up
/// its shine. A small texture, wrapped round the head as it is at rest. Needs a current context.
class SkinGrain {
 public:
  SkinGrain();

  /// Where on the texture the vertices of a head at rest lie. Out of 8 bits, from the same numbers
  /// every time.
  [[nodiscard]] static std::vector<glm::vec2> places(std::span<const glm::vec3> rest);
  /// To the texture unit that is active.
  void bind() const;

 private:
  Texture texture_;
};

}  // namespace aucast::render
