#include "client/render/face_renderer.h"

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "client/render/mesh_buffers.h"
#include "client/render/mesh_lines.h"
#include "client/render/programs.h"
#include "client/render/segment_renderer.h"
#include "client/render/shadow_map.h"
#include "client/render/skin_grain.h"
#include "client/view/viewpoint.h"
#include "common/check.h"

namespace aucast::render {
namespace {

using view::Shader;

/// Opacity of a transparent surface, and of what shines through a solid one.
constexpr float kTransparent = 0.45F;
constexpr float kShineThrough = 0.45F;

void set(const Program& program, const char* name, float value) {
  glUniform1f(uniform(program, name), value);
}

void set(const Program& program, const char* name, const glm::vec3& value) {
  glUniform3fv(uniform(program, name), 1, glm::value_ptr(value));
}

}  // namespace

struct FaceRenderer::State {
  ShaderFiles files;
  Programs programs;
  MeshBuffers mesh;
  view::MovingMesh moving;
  VertexArray no_vertices;
  SegmentRenderer segments;
  ShadowMap shadow;
  SkinGrain grain;
  BlockBuffer<CameraBlock> camera;
  BlockBuffer<LightsBlock> lights;

  void draw_surface(const view::Style& style);
  void draw_transparent(const view::Style& style);
  void draw_depth(const std::vector<Run>& runs);
  void draw_segments(const view::Style& style);
  [[nodiscard]] const Program& program_for(Shader shader) const;
  /// The opaque runs to draw: not rounded if the mesh's lines or points are shown, which lie on its
  /// own triangles.
  [[nodiscard]] const std::vector<Run>& solid(const view::Layers& layers) const {
    return layers.wireframe || layers.vertices ? mesh.plain() : mesh.solid();
  }
  void draw_shadow_map();
  /// Leaves the mesh bound.
  void draw_backdrop(const view::Style& style);
  void draw_runs(const std::vector<Run>& runs);
  void draw_creases(std::span<const float> strengths);
};

const Program& FaceRenderer::State::program_for(Shader shader) const {
  if (shader == Shader::Hair) return programs.hair;
  return shader == Shader::Eye ? programs.eye : programs.surface;
}

void FaceRenderer::State::draw_shadow_map() {
  shadow.draw(programs.depth, [this] {
    for (const Run& run : mesh.plain()) {
      if (run.material.encloses()) run.draw();
    }
  });
}

void FaceRenderer::State::draw_backdrop(const view::Style& style) {
  glUseProgram(programs.backdrop.id());
  set(programs.backdrop, "u_centre", style.background.centre);
  set(programs.backdrop, "u_edge", style.background.edge);
  set(programs.backdrop, "u_square", style.background.squares_px);
  glBindVertexArray(no_vertices.id());
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
  mesh.bind(style.layers.textured);
}

void FaceRenderer::State::draw_runs(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const Program& program = program_for(run.material.shader);
    glUseProgram(program.id());
    mesh.materials().use(run.block);
    if (run.material.shader == Shader::Eye && run.index >= 0) {
      const auto at = static_cast<std::size_t>(run.index);
      AUCAST_CHECK(at < moving.eye_centres.size() && at < moving.eye_forward.size());
      set(program, "u_eyeball_centre", moving.eye_centres[at]);
      set(program, "u_eyeball_forward", moving.eye_forward[at]);
      set(program, "u_eyeball_open", at < moving.eye_open.size() ? moving.eye_open[at] : 1.0F);
    }
    (run.material.two_sided ? glDisable : glEnable)(GL_CULL_FACE);
    // Hair that is not blended has an outline of single strands, as fine as the samples.
    const bool strands = run.material.shader == Shader::Hair && !glIsEnabled(GL_BLEND);
    if (strands) glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    run.draw();
    if (strands) glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  }
}

void FaceRenderer::State::draw_creases(std::span<const float> strengths) {
  glUseProgram(programs.crease.id());
  glBlendFuncSeparate(GL_DST_COLOR, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  const GLint strength = uniform(programs.crease, "u_strength");
  for (const Run& run : mesh.creases()) {
    const auto at = static_cast<std::size_t>(run.index);
    if (run.index < 0 || at >= strengths.size() || !(strengths[at] > 0)) continue;
    mesh.materials().use(run.block);
    glUniform1f(strength, strengths[at]);
    run.draw();
  }
  glDepthMask(GL_TRUE);
}

void FaceRenderer::State::draw_surface(const view::Style& style) {
  if (style.layers.transparent) {
    draw_transparent(style);
  } else {
    draw_runs(solid(style.layers));
    draw_backdrop(style);
  }
  if (!style.layers.textured) return;  // what is left is nothing but colour
  glEnable(GL_BLEND);
  draw_creases(moving.creases);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  // Brows and lashes lie on the skin, which is coarser: half a millimetre towards the viewer.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -12'000);  // steps of 24 bits of depth
  draw_runs(mesh.translucent());
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

/// Draws eyes, teeth and mouth as they are, and over them one layer of what encloses them.
void FaceRenderer::State::draw_transparent(const view::Style& style) {
  std::vector<Run> inner;
  std::vector<Run> outer;
  for (const Run& run : solid(style.layers)) {
    (run.material.encloses() ? outer : inner).push_back(run);
  }
  draw_backdrop(style);
  draw_runs(inner);
  draw_depth(outer);
  glEnable(GL_BLEND);
  glBlendColor(0, 0, 0, kTransparent);
  glBlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_ZERO, GL_ONE);
  draw_runs(outer);
  glDisable(GL_BLEND);
}

/// Draws only into the depth buffer.
void FaceRenderer::State::draw_depth(const std::vector<Run>& runs) {
  glUseProgram(programs.depth.id());
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDisable(GL_CULL_FACE);
  for (const Run& run : runs) run.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void FaceRenderer::State::draw_segments(const view::Style& style) {
  const bool solid_surface = style.layers.surface() && !style.layers.transparent;
  if (!style.tags.empty()) {
    segments.load(style.tags);
    segments.draw(programs.segments, 1);
  }
  if (style.diagram.empty()) return;
  segments.load(style.diagram);
  if (solid_surface) {
    glDepthFunc(GL_GREATER);
    segments.draw(programs.segments, kShineThrough);
    glDepthFunc(GL_LEQUAL);
    segments.draw(programs.segments, 1);
  } else {
    glDisable(GL_DEPTH_TEST);
    segments.draw(programs.segments, 1);
    glEnable(GL_DEPTH_TEST);
  }
}

FaceRenderer::FaceRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
FaceRenderer::~FaceRenderer() = default;

Result<std::unique_ptr<FaceRenderer>> FaceRenderer::create() {
  auto state = std::make_unique<State>();
  auto programs = build_programs(state->files);
  if (!programs.has_value()) return programs.error();
  state->programs = std::move(*programs);
  return std::unique_ptr<FaceRenderer>(new FaceRenderer(std::move(state)));
}

Result<void> FaceRenderer::renew_shaders() {
  if (!state_->files.changed()) return {};
  auto built = build_programs(state_->files);
  if (!built.has_value()) return built.error();
  state_->programs = std::move(*built);
  return {};
}

void FaceRenderer::load(const view::StaticMesh& mesh) {
  state_->mesh.load(mesh);
}

void FaceRenderer::pose(const view::MovingMesh& mesh) {
  state_->mesh.place(mesh);
  state_->moving = mesh;
}

void FaceRenderer::draw(const view::Viewpoint& viewpoint, const view::Style& style, int width,
                        int height) {
  State& state = *state_;
  state.mesh.bind(style.layers.textured);
  // WebGL draws nothing with a block that has no buffer, whether the program reads it or not.
  if (!state.mesh.plain().empty()) state.mesh.materials().use();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glFrontFace(GL_CCW);
  glCullFace(GL_BACK);
  LightsBlock lights;
  lights.key_direction = glm::normalize(style.light.direction);
  lights.key_strength = style.light.strength;
  state.lights.set(lights);
  state.lights.use();
  state.shadow.aim(lights.key_direction);
  if (style.layers.surface()) state.draw_shadow_map();

  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const view::ViewMatrices matrices = view::view_matrices(viewpoint, width, height);
  state.camera.set({.world_to_clip = matrices.projection * matrices.view,
                    .world_to_shadow = state.shadow.world_to_texture(),
                    .eye = matrices.eye,
                    .scale = style.scale,
                    .viewport_px = {width, height}});
  state.camera.use();
  state.grain.bind(kGrainUnit);
  state.shadow.bind(kShadowUnit);
  if (style.layers.surface()) {
    state.draw_surface(style);
  } else {
    state.draw_backdrop(style);
    // Lines that the face itself would hide are left out.
    if (!style.layers.transparent) state.draw_depth(state.solid(style.layers));
  }
  draw_mesh_lines(state.programs.lines, state.mesh, style);
  state.draw_segments(style);
  glBindVertexArray(0);
}

}  // namespace aucast::render
