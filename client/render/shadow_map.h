#pragma once

#include <functional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"
#include "client/render/uniform_blocks.h"

namespace aucast::render {

/// How far the key light reaches, seen from the light. Needs a current context.
class ShadowMap {
 public:
  ShadowMap();

  /// Where the next draw() is seen from; `towards_key`: of unit length.
  void aim(const glm::vec3& towards_key);
  /// `draw_casters` draws all that casts a shadow, with the program `depth`. Leaves the light's
  /// camera in force.
  void draw(const Program& depth, const std::function<void()>& draw_casters);
  void bind(GLenum unit) const;
  /// Into [0,1] of the map.
  [[nodiscard]] const glm::mat4& world_to_texture() const { return world_to_texture_; }

 private:
  Texture depths_;
  Framebuffer target_;
  BlockBuffer<CameraBlock> camera_;
  glm::mat4 world_to_clip_{1};
  glm::mat4 world_to_texture_{1};
};

}  // namespace aucast::render
