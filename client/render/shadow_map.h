#pragma once

#include <functional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"
#include "common/result.h"

namespace aucast::render {

/// How far the key light reaches, seen from the light. Needs a current context.
class ShadowMap {
 public:
  [[nodiscard]] static Result<ShadowMap> create();

  /// Aims the light; `towards_key`: of unit length.
  void aim(const glm::vec3& towards_key);
  /// `draw_casters` draws all that casts a shadow, with the program that is in use.
  void draw(const std::function<void()>& draw_casters);
  /// To the texture unit that is active.
  void bind() const;
  /// Into [0,1] of the map.
  [[nodiscard]] const glm::mat4& world_to_texture() const { return world_to_texture_; }

 private:
  explicit ShadowMap(Program depth);

  Program depth_;
  Texture depths_;
  Framebuffer target_;
  glm::mat4 world_to_clip_{1};
  glm::mat4 world_to_texture_{1};
};

}  // namespace aucast::render
