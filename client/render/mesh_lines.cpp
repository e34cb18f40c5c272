#include "client/render/mesh_lines.h"

#include <algorithm>
#include <array>
#include <span>

#include <glm/gtc/type_ptr.hpp>

namespace aucast::render {
namespace {

/// A colour that contrasts with what is behind the lines.
glm::vec4 line_colour(const view::Style& style) {
  if (style.layers.surface()) return {0.02F, 0.03F, 0.05F, 0.45F};
  const glm::vec3& ground = style.background.centre;
  const bool bright = ground.r + ground.g + ground.b > 1.2F;
  return bright ? glm::vec4(0.10F, 0.16F, 0.24F, 0.8F) : glm::vec4(0.70F, 0.82F, 0.90F, 0.8F);
}

#if !defined(__EMSCRIPTEN__)
void fill_with_lines(std::span<const Run> runs, const view::Layers& layers) {
  glEnable(GL_PROGRAM_POINT_SIZE);
  glPolygonOffset(-1, -1);
  for (const GLenum mode : std::array<GLenum, 2>{GL_LINE, GL_POINT}) {
    if (!(mode == GL_LINE ? layers.wireframe : layers.vertices)) continue;
    const GLenum offset = mode == GL_LINE ? GL_POLYGON_OFFSET_LINE : GL_POLYGON_OFFSET_POINT;
    glPolygonMode(GL_FRONT_AND_BACK, mode);
    glEnable(offset);
    for (const Run& run : runs) run.draw();
    glDisable(offset);
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_PROGRAM_POINT_SIZE);
}
#endif

/// OpenGL ES has neither outlined triangles nor an offset for lines: the shader moves the lines
/// nearer.
void draw_lines(const MeshBuffers& mesh, const view::Layers& layers) {
  if (layers.wireframe) mesh.draw_edges();
  if (!layers.vertices) return;
  for (const Run& run : mesh.plain()) run.draw_points();
}

}  // namespace

void draw_mesh_lines(const Program& lines, const MeshBuffers& mesh, const view::Style& style) {
  if (!style.layers.wireframe && !style.layers.vertices) return;
  glUseProgram(lines.id());
  const glm::vec4 colour = line_colour(style);
  glUniform4fv(uniform(lines, "u_colour"), 1, glm::value_ptr(colour));
  glUniform1f(uniform(lines, "u_point_px"), std::max(1.0F, 2.0F * style.scale));
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
#if defined(__EMSCRIPTEN__)
  draw_lines(mesh, style.layers);
#else
  if (is_desktop_gl()) {
    fill_with_lines(mesh.plain(), style.layers);
  } else {
    draw_lines(mesh, style.layers);
  }
#endif
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

}  // namespace aucast::render
