#include "client/render/shadow_map.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace aucast::render {
namespace {

constexpr int kShadowSide = 256;  ///< texels of 0.1 mesh units; every sample is spread over several
/// The box is fixed, so that shadows do not crawl while the head moves.
constexpr glm::vec3 kCentre{0, 0, 1};
constexpr float kReach = 13;
constexpr float kBias = 0.10F;
constexpr float kSlopeBias = 2.0F;

/// Binds the framebuffer again, when destroyed, that was bound when it was made.
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

ShadowMap::ShadowMap() {
  glBindTexture(GL_TEXTURE_2D, depths_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kShadowSide, kShadowSide, 0,
               GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);

  const BoundFramebuffer before;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_.id());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_.id(), 0);
  const GLenum none = GL_NONE;
  glDrawBuffers(1, &none);
}

void ShadowMap::aim(const glm::vec3& towards_key) {
  const glm::mat4 view = glm::lookAt(kCentre + towards_key * kReach, kCentre, glm::vec3(0, 1, 0));
  world_to_clip_ = glm::ortho(-kReach, kReach, -kReach, kReach, 0.0F, 2 * kReach) * view;
  const glm::mat4 to_texture =
      glm::translate(glm::mat4(1), glm::vec3(0.5F, 0.5F, 0.5F - kBias / (2 * kReach)));
  world_to_texture_ = glm::scale(to_texture, glm::vec3(0.5F)) * world_to_clip_;
}

void ShadowMap::draw(const Program& depth, const std::function<void()>& draw_casters) {
  const BoundFramebuffer before;
  glViewport(0, 0, kShadowSide, kShadowSide);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_.id());
  glClear(GL_DEPTH_BUFFER_BIT);
  // The texels at the border stay at the greatest depth: outside the box everything is lit.
  glEnable(GL_SCISSOR_TEST);
  glScissor(1, 1, kShadowSide - 2, kShadowSide - 2);
  glUseProgram(depth.id());
  CameraBlock camera;
  camera.world_to_clip = world_to_clip_;
  camera_.set(camera);
  camera_.use();
  glDisable(GL_CULL_FACE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kSlopeBias, 0);
  draw_casters();
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_SCISSOR_TEST);
}

void ShadowMap::bind(GLenum unit) const {
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, depths_.id());
}

}  // namespace aucast::render
