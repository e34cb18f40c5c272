#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/render/gl_objects.h"
#include "common/result.h"

namespace aucast::render {

/// How a surface answers the light, as the shaders want it.
struct Answer {
  float wrap = 1;
  float specular = 0;
  float power = 20;
  float shadow_kept = 0;
  float grain = 0;
};

/// The program of lit surfaces for one of the materials of shaders.h. Needs a current context.
class LitProgram {
 public:
  /// `define`: kAsSurface, kAsHair or kAsEye.
  [[nodiscard]] static Result<LitProgram> create(const char* name, const char* define);

  void set_camera(const glm::mat4& world_to_clip, const glm::mat4& world_to_shadow,
                  const glm::vec3& eye);
  /// `towards`: of unit length.
  void set_key_light(const glm::vec3& towards, float strength);
  void use(const Answer& answer);
  void set_eyeball(const glm::vec3& centre, const glm::vec3& forward, float open);

 private:
  explicit LitProgram(Program program);

  Program program_;
  GLint world_to_clip_ = -1;
  GLint world_to_shadow_ = -1;
  GLint key_direction_ = -1;
  GLint key_strength_ = -1;
  GLint eye_ = -1;
  GLint wrap_ = -1;
  GLint specular_ = -1;
  GLint power_ = -1;
  GLint shadow_kept_ = -1;
  GLint grain_ = -1;
  GLint eyeball_centre_ = -1;
  GLint eyeball_forward_ = -1;
  GLint eyeball_open_ = -1;
};

}  // namespace aucast::render
