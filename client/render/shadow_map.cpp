#include "client/render/shadow_map.h"

#include <array>
#include <utility>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "client/render/shaders.h"

namespace aucast::render {
namespace {

constexpr int kSide = 256;  // texels of 0.1 units: every look at them is spread over several
/// The box is fixed, so that shadows do not crawl while the head moves.
constexpr glm::vec3 kCentre{0, 0, 1};
constexpr float kReach = 13;
constexpr float kBias = 0.10F;
constexpr float kSlopeBias = 2.0F;

/// Puts back the framebuffer that was bound.
class BoundFramebuffer {
 public:
  BoundFramebuffer() { glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before_); }
  ~BoundFramebuffer() { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before_)); }
  BoundFramebuffer(const BoundFramebuffer&) = delete;
  BoundFramebuffer& operator=(const BoundFramebuffer&) = delete;

 private:
  GLint before_ = 0;
};

}  // namespace

Result<ShadowMap> ShadowMap::create() {
  namespace glsl = shaders;
  auto depth = build_program("shadow", std::array{glsl::kVersion, glsl::kDepthVertex},
                             std::array{glsl::kVersion, glsl::kDepthFragment});
  if (!depth.has_value()) return depth.error();
  return ShadowMap(std::move(depth.value()));
}

ShadowMap::ShadowMap(Program depth) : depth_(std::move(depth)) {
  glBindTexture(GL_TEXTURE_2D, depths_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSide, kSide, 0, GL_DEPTH_COMPONENT,
               GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  // Outside the box everything is lit.
  const std::array<GLfloat, 4> farthest{1, 1, 1, 1};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);

  const BoundFramebuffer before;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_.id());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_.id(), 0);
  glDrawBuffer(GL_NONE);
}

void ShadowMap::aim(const glm::vec3& towards_key) {
  const glm::mat4 view = glm::lookAt(kCentre + towards_key * kReach, kCentre, glm::vec3(0, 1, 0));
  world_to_clip_ = glm::ortho(-kReach, kReach, -kReach, kReach, 0.0F, 2 * kReach) * view;
  const glm::mat4 to_texture =
      glm::translate(glm::mat4(1), glm::vec3(0.5F, 0.5F, 0.5F - kBias / (2 * kReach)));
  world_to_texture_ = glm::scale(to_texture, glm::vec3(0.5F)) * world_to_clip_;
}

void ShadowMap::draw(const std::function<void()>& draw_casters) {
  const BoundFramebuffer before;
  glViewport(0, 0, kSide, kSide);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_.id());
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(depth_.id());
  glUniformMatrix4fv(glGetUniformLocation(depth_.id(), "u_world_to_clip"), 1, GL_FALSE,
                     glm::value_ptr(world_to_clip_));
  glDisable(GL_CULL_FACE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kSlopeBias, 0);
  draw_casters();
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShadowMap::bind() const {
  glBindTexture(GL_TEXTURE_2D, depths_.id());
}

}  // namespace aucast::render
