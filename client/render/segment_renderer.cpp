#include "client/render/segment_renderer.h"

#include <array>
#include <cstddef>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "client/render/shaders.h"

namespace aucast::render {
namespace {

void per_segment(GLuint slot, GLint components, std::size_t offset) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot, components, GL_FLOAT, GL_FALSE, sizeof(view::Segment),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(slot, 1);
}

}  // namespace

SegmentRenderer::SegmentRenderer(Program program) : program_(std::move(program)) {
  glBindVertexArray(array_.id());
  glBindBuffer(GL_ARRAY_BUFFER, segments_.id());
  per_segment(0, 3, offsetof(view::Segment, from));
  per_segment(1, 3, offsetof(view::Segment, to));
  per_segment(2, 4, offsetof(view::Segment, colour));
  per_segment(3, 1, offsetof(view::Segment, width_px));
  glBindVertexArray(0);
}

Result<SegmentRenderer> SegmentRenderer::create() {
  namespace glsl = shaders;
  auto program = build_program("segments", std::array{glsl::kVersion, glsl::kSegmentVertex},
                               std::array{glsl::kVersion, glsl::kSegmentFragment});
  if (!program.has_value()) return program.error();
  return SegmentRenderer(std::move(program.value()));
}

void SegmentRenderer::load(std::span<const view::Segment> segments, const glm::mat4& world_to_clip,
                           int width, int height, float scale) {
  count_ = static_cast<GLsizei>(segments.size());
  glBindBuffer(GL_ARRAY_BUFFER, segments_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(segments.size_bytes()), segments.data(),
               GL_STREAM_DRAW);
  glUseProgram(program_.id());
  const auto location = [this](const char* name) {
    return glGetUniformLocation(program_.id(), name);
  };
  glUniformMatrix4fv(location("u_world_to_clip"), 1, GL_FALSE, glm::value_ptr(world_to_clip));
  glUniform2f(location("u_viewport_px"), static_cast<float>(width), static_cast<float>(height));
  glUniform1f(location("u_scale"), scale);
}

void SegmentRenderer::draw(float alpha) {
  if (count_ == 0) return;
  glUseProgram(program_.id());
  glUniform1f(glGetUniformLocation(program_.id(), "u_alpha"), alpha);
  glBindVertexArray(array_.id());
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace aucast::render
