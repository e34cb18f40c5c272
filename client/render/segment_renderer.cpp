#include "client/render/segment_renderer.h"

#include <cstddef>

namespace aucast::render {
namespace {

void per_segment(GLuint slot, GLint components, std::size_t position) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot, components, GL_FLOAT, GL_FALSE, sizeof(view::Segment),
                        reinterpret_cast<const void*>(position));
  glVertexAttribDivisor(slot, 1);
}

}  // namespace

SegmentRenderer::SegmentRenderer() {
  glBindVertexArray(array_.id());
  glBindBuffer(GL_ARRAY_BUFFER, segments_.id());
  per_segment(0, 3, offsetof(view::Segment, from));
  per_segment(1, 3, offsetof(view::Segment, to));
  per_segment(2, 4, offsetof(view::Segment, colour));
  per_segment(3, 1, offsetof(view::Segment, width_px));
  glBindVertexArray(0);
}

void SegmentRenderer::load(std::span<const view::Segment> segments) {
  count_ = static_cast<GLsizei>(segments.size());
  glBindBuffer(GL_ARRAY_BUFFER, segments_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(segments.size_bytes()), segments.data(),
               GL_STREAM_DRAW);
}

void SegmentRenderer::draw(const Program& program, float alpha) const {
  if (count_ == 0) return;
  glUseProgram(program.id());
  glUniform1f(uniform(program, "u_alpha"), alpha);
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
