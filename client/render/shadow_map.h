#pragma once

#include <functional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"
#include "client/render/uniform_blocks.h"

namespace aucast::render {

/// A depth map of the face seen from the key light: what the light does not see lies in shadow.
/// Needs a current context as long as it lives.
class ShadowMap {
 public:
  ShadowMap();

  /// Sets the direction from which the next draw() looks. `towards_key`: unit length.
  void aim(const glm::vec3& towards_key);
  /// Draws the map with the program `depth`; `draw_casters` must draw all that casts a shadow.
  /// Afterwards the programs still use the light's camera.
  void draw(const Program& depth, const std::function<void()>& draw_casters);
  void bind(GLenum unit) const;
  /// The matrix from a place to its coordinates on the map (x and y) and its depth (z), in [0,1].
  [[nodiscard]] const glm::mat4& world_to_texture() const { return world_to_texture_; }

 private:
  Texture depths_;
  Framebuffer target_;
  BlockBuffer<CameraBlock> camera_;
  glm::mat4 world_to_clip_{1};
  glm::mat4 world_to_texture_{1};
};

}  // namespace aucast::render
