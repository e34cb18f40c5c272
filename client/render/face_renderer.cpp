#include "client/render/face_renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "client/render/gl_objects.h"
#include "client/render/lit_program.h"
#include "client/render/look.h"
#include "client/render/segment_renderer.h"
#include "client/render/shaders.h"
#include "client/render/shadow_map.h"
#include "client/render/skin_grain.h"
#include "client/view/camera.h"
#include "client/view/rounded_mesh.h"
#include "client/view/strands.h"
#include "common/check.h"

namespace aucast::render {
namespace {

using view::Shading;
using Triangle = view::RoundedMesh::Triangle;

/// A quarter of a pixel in a face that fills the screen: no corner shows there.
constexpr float kLeastBend = 0.004F;

/// What is left of a transparent surface, and of what shines through a solid one.
constexpr float kTransparent = 0.45F;
constexpr float kShineThrough = 0.45F;
constexpr glm::vec3 kClay{0.52F, 0.47F, 0.43F};  ///< the surface in a plain colour

constexpr GLuint kPositionSlot = 0;
constexpr GLuint kNormalSlot = 1;
constexpr GLuint kColourSlot = 2;
constexpr GLuint kOcclusionGlossSlot = 3;
constexpr GLuint kGrainSlot = 4;
constexpr GLuint kStrandSlot = 5;

/// A run of indices with one look.
struct Draw {
  Shading shading = Shading::Skin;
  Faces faces = Faces::Both;
  int index = -1;  ///< of the eye or the crease
  bool rounded = false;
  std::size_t first_index = 0;
  GLsizei index_count = 0;
};

void draw_triangles(const Draw& draw) {
  glDrawElements(GL_TRIANGLES, draw.index_count, GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(draw.first_index * sizeof(std::uint32_t)));
}

int index_of(const view::ShadedRange& range) {
  if (range.shading == Shading::Crease) return range.crease;
  return range.shading == Shading::Eye ? range.eye : -1;
}

/// Outermost first, so that what lies beneath is never shaded: hair over skin over eyes and teeth.
void order_solids(std::vector<Draw>& draws) {
  const auto layer = [](const Draw& draw) {
    switch (draw.shading) {
      case Shading::Hair:
        return 0;
      case Shading::Cloth:
        return 1;
      case Shading::Skin:
        return 2;
      default:
        return 3;
    }
  };
  std::stable_sort(draws.begin(), draws.end(),
                   [&layer](const Draw& a, const Draw& b) { return layer(a) < layer(b); });
}

void attribute(GLuint slot, GLint components) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

template <typename T>
void upload(GLenum target, std::span<const T> data, GLenum usage) {
  glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
}

/// Lines and points of the mesh stand out from what is behind them.
glm::vec4 line_colour(const view::Style& style) {
  if (style.layers.surface()) return {0.02F, 0.03F, 0.05F, 0.45F};
  const glm::vec3& ground = style.background.centre;
  const bool bright = ground.r + ground.g + ground.b > 1.2F;
  return bright ? glm::vec4(0.10F, 0.16F, 0.24F, 0.8F) : glm::vec4(0.70F, 0.82F, 0.90F, 0.8F);
}

}  // namespace

struct FaceRenderer::State {
  LitProgram surface;
  LitProgram hair;
  LitProgram eye;
  Program crease;
  Program depth;
  Program backdrop;
  Program flat;
  SegmentRenderer segments;
  VertexArray vertices;
  VertexArray no_vertices;
  Buffer positions;
  Buffer normals;
  Buffer colours;
  Buffer occlusion_gloss;
  Buffer grain_places;
  Buffer strand_ways;
  Buffer indices;
  ShadowMap shadow;
  SkinGrain grain;
  view::Strands strands;

  std::size_t vertex_count = 0;
  bool grained = false;
  view::RoundedMesh rounded;
  std::vector<Draw> solid;
  std::vector<Draw> plain;  ///< the same without rounding
  std::vector<Draw> translucent;
  std::vector<Draw> creases;

  State(LitProgram surface_program, LitProgram hair_program, LitProgram eye_program,
        Program crease_program, Program depth_program, Program backdrop_program,
        Program flat_program, SegmentRenderer segment_renderer, ShadowMap shadow_map)
      : surface(std::move(surface_program)),
        hair(std::move(hair_program)),
        eye(std::move(eye_program)),
        crease(std::move(crease_program)),
        depth(std::move(depth_program)),
        backdrop(std::move(backdrop_program)),
        flat(std::move(flat_program)),
        segments(std::move(segment_renderer)),
        shadow(std::move(shadow_map)) {}

  void set_up();
  void round_off(std::span<const glm::vec3> rest, std::vector<Triangle>& triangles);
  void upload_moving(const view::MovingMesh& mesh);
  void set_programs(const view::Style& style, const view::CameraMatrices& matrices,
                    const glm::mat4& world_to_clip);
  void draw_surface(const view::MovingMesh& mesh, const view::Style& style,
                    const view::CameraMatrices& matrices, const glm::mat4& world_to_clip);
  void draw_transparent(const view::MovingMesh& mesh, const view::Style& style,
                        const glm::mat4& world_to_clip);
  void draw_depth(const std::vector<Draw>& draws, const glm::mat4& world_to_clip);
  void draw_lines(const view::Style& style, const glm::mat4& world_to_clip);
  void draw_segments(const view::Style& style, const glm::mat4& world_to_clip, int width,
                     int height);
  [[nodiscard]] LitProgram& program_for(Shading shading);
  /// The mesh's own lines and points lie on its own triangles.
  [[nodiscard]] const std::vector<Draw>& runs(const view::Layers& layers) const {
    return layers.wireframe || layers.vertices ? plain : solid;
  }
  void draw_shadow_map();
  void draw_backdrop(const view::Background& background);
  void draw_runs(const std::vector<Draw>& draws, const view::MovingMesh& mesh);
  void draw_creases(std::span<const float> strengths, const glm::mat4& world_to_clip,
                    const glm::vec3& eye_place);
};

void FaceRenderer::State::set_up() {
  glBindVertexArray(vertices.id());
  const std::array<std::pair<const Buffer*, std::pair<GLuint, GLint>>, 6> attributes{
      {{&positions, {kPositionSlot, 3}},
       {&normals, {kNormalSlot, 3}},
       {&colours, {kColourSlot, 4}},
       {&occlusion_gloss, {kOcclusionGlossSlot, 2}},
       {&grain_places, {kGrainSlot, 2}},
       {&strand_ways, {kStrandSlot, 4}}}};
  for (const auto& [buffer, layout] : attributes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer->id());
    attribute(layout.first, layout.second);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  glBindVertexArray(0);
}

LitProgram& FaceRenderer::State::program_for(Shading shading) {
  if (shading == Shading::Hair) return hair;
  return shading == Shading::Eye ? eye : surface;
}

void FaceRenderer::State::draw_shadow_map() {
  shadow.draw([this] {
    for (const Draw& draw : plain) {
      if (look_of(draw.shading).casts_shadow) draw_triangles(draw);
    }
  });
}

void FaceRenderer::State::draw_backdrop(const view::Background& background) {
  glUseProgram(backdrop.id());
  glUniform3fv(glGetUniformLocation(backdrop.id(), "u_centre"), 1,
               glm::value_ptr(background.centre));
  glUniform3fv(glGetUniformLocation(backdrop.id(), "u_edge"), 1, glm::value_ptr(background.edge));
  glBindVertexArray(no_vertices.id());
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
  glBindVertexArray(vertices.id());
}

void FaceRenderer::State::draw_runs(const std::vector<Draw>& draws, const view::MovingMesh& mesh) {
  for (const Draw& draw : draws) {
    const Look look = look_of(draw.shading);
    LitProgram& program = program_for(draw.shading);
    program.use(
        {look.wrap, look.specular, look.power, look.shadow_kept, grained ? look.grain : 0.0F});
    if (draw.index >= 0) {
      const auto at = static_cast<std::size_t>(draw.index);
      AUCAST_CHECK(at < mesh.eye_centres.size() && at < mesh.eye_forward.size());
      const float open = at < mesh.eye_open.size() ? mesh.eye_open[at] : 1.0F;
      program.set_eyeball(mesh.eye_centres[at], mesh.eye_forward[at], open);
    }
    if (draw.faces == Faces::Both) {
      glDisable(GL_CULL_FACE);
    } else {
      glEnable(GL_CULL_FACE);
      glCullFace(GL_BACK);
    }
    draw_triangles(draw);
  }
}

void FaceRenderer::State::draw_creases(std::span<const float> strengths,
                                       const glm::mat4& world_to_clip, const glm::vec3& eye_place) {
  const auto location = [this](const char* name) {
    return glGetUniformLocation(crease.id(), name);
  };
  glUseProgram(crease.id());
  glUniformMatrix4fv(location("u_world_to_clip"), 1, GL_FALSE, glm::value_ptr(world_to_clip));
  glUniform3fv(location("u_eye"), 1, glm::value_ptr(eye_place));
  const GLint strength = location("u_strength");
  glBlendFuncSeparate(GL_DST_COLOR, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  for (const Draw& draw : creases) {
    const auto at = static_cast<std::size_t>(draw.index);
    if (draw.index < 0 || at >= strengths.size() || !(strengths[at] > 0)) continue;
    glUniform1f(strength, strengths[at]);
    draw_triangles(draw);
  }
  glDepthMask(GL_TRUE);
}

void FaceRenderer::State::upload_moving(const view::MovingMesh& mesh) {
  rounded.place(mesh.positions, mesh.normals);
  glBindVertexArray(vertices.id());
  glBindBuffer(GL_ARRAY_BUFFER, positions.id());
  upload(GL_ARRAY_BUFFER, rounded.positions(), GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, normals.id());
  upload(GL_ARRAY_BUFFER, rounded.normals(), GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, strand_ways.id());
  upload(GL_ARRAY_BUFFER, strands.place(mesh.positions), GL_STREAM_DRAW);
}

void FaceRenderer::State::set_programs(const view::Style& style,
                                       const view::CameraMatrices& matrices,
                                       const glm::mat4& world_to_clip) {
  for (LitProgram* program : {&surface, &hair, &eye}) {
    program->set_camera(world_to_clip, shadow.world_to_texture(), matrices.eye);
    program->set_key_light(glm::normalize(style.light.direction), style.light.strength);
  }
  glActiveTexture(GL_TEXTURE1);
  grain.bind();
  glActiveTexture(GL_TEXTURE0);
  shadow.bind();
  if (style.layers.textured) {
    glEnableVertexAttribArray(kColourSlot);
    glEnableVertexAttribArray(kStrandSlot);
  } else {
    glDisableVertexAttribArray(kStrandSlot);
    glVertexAttrib4f(kStrandSlot, 0, 0, 0, 0);
    glDisableVertexAttribArray(kColourSlot);
    glVertexAttrib4f(kColourSlot, kClay.r, kClay.g, kClay.b, 1);
  }
}

void FaceRenderer::State::draw_surface(const view::MovingMesh& mesh, const view::Style& style,
                                       const view::CameraMatrices& matrices,
                                       const glm::mat4& world_to_clip) {
  if (style.layers.transparent) {
    draw_transparent(mesh, style, world_to_clip);
  } else {
    draw_runs(runs(style.layers), mesh);
    draw_backdrop(style.background);
  }
  if (!style.layers.textured) return;  // what is left is nothing but colour
  glEnable(GL_BLEND);
  draw_creases(mesh.creases, world_to_clip, matrices.eye);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  // Brows and lashes lie on the skin, which is coarser: half a millimetre towards the viewer.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -12'000);  // steps of 24 bits of depth
  draw_runs(translucent, mesh);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

/// Eyes, teeth and mouth as they are, over them one layer of what encloses them.
void FaceRenderer::State::draw_transparent(const view::MovingMesh& mesh, const view::Style& style,
                                           const glm::mat4& world_to_clip) {
  std::vector<Draw> inner;
  std::vector<Draw> outer;
  for (const Draw& draw : runs(style.layers)) {
    const bool encloses = look_of(draw.shading).casts_shadow;
    (encloses ? outer : inner).push_back(draw);
  }
  draw_backdrop(style.background);
  draw_runs(inner, mesh);
  draw_depth(outer, world_to_clip);
  glEnable(GL_BLEND);
  glBlendColor(0, 0, 0, kTransparent);
  glBlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_ZERO, GL_ONE);
  draw_runs(outer, mesh);
  glDisable(GL_BLEND);
}

/// What hides, without a colour.
void FaceRenderer::State::draw_depth(const std::vector<Draw>& draws,
                                     const glm::mat4& world_to_clip) {
  glUseProgram(depth.id());
  glUniformMatrix4fv(glGetUniformLocation(depth.id(), "u_world_to_clip"), 1, GL_FALSE,
                     glm::value_ptr(world_to_clip));
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDisable(GL_CULL_FACE);
  for (const Draw& draw : draws) {
    draw_triangles(draw);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void FaceRenderer::State::draw_lines(const view::Style& style, const glm::mat4& world_to_clip) {
  if (!style.layers.wireframe && !style.layers.vertices) return;
  glUseProgram(flat.id());
  const auto location = [this](const char* name) { return glGetUniformLocation(flat.id(), name); };
  glUniformMatrix4fv(location("u_world_to_clip"), 1, GL_FALSE, glm::value_ptr(world_to_clip));
  const glm::vec4 colour = line_colour(style);
  glUniform4fv(location("u_colour"), 1, glm::value_ptr(colour));
  glUniform1f(location("u_point_px"), std::max(1.0F, 2.0F * style.scale));
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glPolygonOffset(-1, -1);
  for (const GLenum mode : std::array<GLenum, 2>{GL_LINE, GL_POINT}) {
    if (!(mode == GL_LINE ? style.layers.wireframe : style.layers.vertices)) continue;
    const GLenum offset = mode == GL_LINE ? GL_POLYGON_OFFSET_LINE : GL_POLYGON_OFFSET_POINT;
    glPolygonMode(GL_FRONT_AND_BACK, mode);
    glEnable(offset);
    for (const Draw& draw : plain) {
      draw_triangles(draw);
    }
    glDisable(offset);
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_PROGRAM_POINT_SIZE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void FaceRenderer::State::draw_segments(const view::Style& style, const glm::mat4& world_to_clip,
                                        int width, int height) {
  const bool solid_surface = style.layers.surface() && !style.layers.transparent;
  if (!style.tags.empty()) {
    segments.load(style.tags, world_to_clip, width, height, style.scale);
    segments.draw(1);
  }
  if (style.diagram.empty()) return;
  segments.load(style.diagram, world_to_clip, width, height, style.scale);
  if (solid_surface) {
    glDepthFunc(GL_GREATER);
    segments.draw(kShineThrough);
    glDepthFunc(GL_LEQUAL);
    segments.draw(1);
  } else {
    glDisable(GL_DEPTH_TEST);
    segments.draw(1);
    glEnable(GL_DEPTH_TEST);
  }
}

FaceRenderer::FaceRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
FaceRenderer::~FaceRenderer() = default;

Result<std::unique_ptr<FaceRenderer>> FaceRenderer::create() {
  namespace glsl = shaders;
  auto surface = LitProgram::create("surface", glsl::kAsSurface);
  if (!surface.has_value()) return surface.error();
  auto hair = LitProgram::create("hair", glsl::kAsHair);
  if (!hair.has_value()) return hair.error();
  auto eye = LitProgram::create("eye", glsl::kAsEye);
  if (!eye.has_value()) return eye.error();
  auto crease = build_program("crease", std::array{glsl::kVersion, glsl::kCreaseVertex},
                              std::array{glsl::kVersion, glsl::kCreaseFragment});
  if (!crease.has_value()) return crease.error();
  auto depth = build_program("depth", std::array{glsl::kVersion, glsl::kDepthVertex},
                             std::array{glsl::kVersion, glsl::kDepthFragment});
  if (!depth.has_value()) return depth.error();
  auto backdrop = build_program("backdrop", std::array{glsl::kVersion, glsl::kBackdropVertex},
                                std::array{glsl::kVersion, glsl::kTone, glsl::kBackdropFragment});
  if (!backdrop.has_value()) return backdrop.error();
  auto flat = build_program("flat", std::array{glsl::kVersion, glsl::kFlatVertex},
                            std::array{glsl::kVersion, glsl::kFlatFragment});
  if (!flat.has_value()) return flat.error();
  auto segments = SegmentRenderer::create();
  if (!segments.has_value()) return segments.error();
  auto shadow = ShadowMap::create();
  if (!shadow.has_value()) return shadow.error();
  auto state = std::make_unique<State>(
      std::move(surface.value()), std::move(hair.value()), std::move(eye.value()),
      std::move(crease.value()), std::move(depth.value()), std::move(backdrop.value()),
      std::move(flat.value()), std::move(segments.value()), std::move(shadow.value()));
  state->set_up();
  return std::unique_ptr<FaceRenderer>(new FaceRenderer(std::move(state)));
}

/// Appends the rounded triangles of the solid runs that ask for it, and points these runs there.
void FaceRenderer::State::round_off(std::span<const glm::vec3> rest,
                                    std::vector<Triangle>& triangles) {
  plain = solid;
  std::vector<Triangle> corners;
  for (const Draw& draw : plain) {
    if (!draw.rounded || rest.empty()) continue;
    const auto begin = triangles.begin() + static_cast<std::ptrdiff_t>(draw.first_index / 3);
    corners.insert(corners.end(), begin, begin + draw.index_count / 3);
  }
  std::vector<glm::vec3> places(rest.begin(), rest.end());
  places.resize(vertex_count);
  rounded = view::RoundedMesh(places, corners, kLeastBend);
  std::size_t given = 0;
  for (Draw& draw : solid) {
    if (!draw.rounded || rest.empty()) continue;
    const std::size_t before = rounded.became(given);
    given += static_cast<std::size_t>(draw.index_count / 3);
    draw.first_index = 3 * (triangles.size() + before);
    draw.index_count = static_cast<GLsizei>(3 * (rounded.became(given) - before));
  }
  triangles.insert(triangles.end(), rounded.triangles().begin(), rounded.triangles().end());
}

void FaceRenderer::load(const view::StaticMesh& mesh) {
  State& state = *state_;
  state.vertex_count = mesh.colours.size();
  AUCAST_CHECK(mesh.occlusion.size() == state.vertex_count);
  AUCAST_CHECK(mesh.gloss.size() == state.vertex_count);
  std::vector<glm::vec2> occlusion_gloss(state.vertex_count);
  for (std::size_t i = 0; i < state.vertex_count; ++i) {
    occlusion_gloss[i] = {mesh.occlusion[i], mesh.gloss[i]};
  }

  // A translucent range is mostly solid (hair): only triangles with a clear corner are blended.
  std::vector<Triangle> sorted;
  state.solid.clear();
  state.translucent.clear();
  state.creases.clear();
  const auto clear_corner = [&mesh](const Triangle& t) {
    return mesh.colours[t[0]].a < 1 || mesh.colours[t[1]].a < 1 || mesh.colours[t[2]].a < 1;
  };
  for (const view::ShadedRange& range : mesh.ranges) {
    AUCAST_CHECK(range.triangle_begin <= mesh.triangles.size());
    AUCAST_CHECK(range.triangle_count <= mesh.triangles.size() - range.triangle_begin);
    const bool crease = range.shading == Shading::Crease;
    for (const bool blended : {false, true}) {
      const std::size_t first = sorted.size();
      for (const auto& triangle :
           mesh.triangles.subspan(range.triangle_begin, range.triangle_count)) {
        const bool clear = !crease && range.translucent && clear_corner(triangle);
        if (clear == blended) sorted.push_back(triangle);
      }
      const std::size_t count = sorted.size() - first;
      if (count == 0) continue;
      const Draw draw{range.shading, look_of(range.shading).faces,   index_of(range), range.rounded,
                      3 * first,     static_cast<GLsizei>(3 * count)};
      (crease ? state.creases : blended ? state.translucent : state.solid).push_back(draw);
    }
  }
  order_solids(state.solid);
  state.round_off(mesh.rest, sorted);
  state.strands = view::Strands(mesh, state.rounded.vertex_count());

  glBindVertexArray(state.vertices.id());
  glBindBuffer(GL_ARRAY_BUFFER, state.colours.id());
  const auto colours = state.rounded.with_edges(mesh.colours);
  upload(GL_ARRAY_BUFFER, std::span<const glm::vec4>(colours), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, state.occlusion_gloss.id());
  occlusion_gloss = state.rounded.with_edges(std::span<const glm::vec2>(occlusion_gloss));
  upload(GL_ARRAY_BUFFER, std::span<const glm::vec2>(occlusion_gloss), GL_STATIC_DRAW);
  state.grained = !mesh.rest.empty();
  glBindBuffer(GL_ARRAY_BUFFER, state.grain_places.id());
  auto places = SkinGrain::places(mesh.rest);
  places.resize(state.vertex_count);
  places = state.rounded.with_edges(std::span<const glm::vec2>(places));
  upload(GL_ARRAY_BUFFER, std::span<const glm::vec2>(places), GL_STATIC_DRAW);
  upload(GL_ELEMENT_ARRAY_BUFFER, std::span<const Triangle>(sorted), GL_STATIC_DRAW);
}

void FaceRenderer::draw(const view::MovingMesh& mesh, const view::Camera& camera,
                        const view::Style& style, int width, int height) {
  State& state = *state_;
  AUCAST_CHECK(mesh.positions.size() == state.vertex_count);
  AUCAST_CHECK(mesh.normals.size() == state.vertex_count);
  state.upload_moving(mesh);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glFrontFace(GL_CCW);
  state.shadow.aim(glm::normalize(style.light.direction));
  if (style.layers.surface()) state.draw_shadow_map();

  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const view::CameraMatrices matrices = view::camera_matrices(camera, width, height);
  const glm::mat4 world_to_clip = matrices.projection * matrices.view;
  state.set_programs(style, matrices, world_to_clip);
  if (style.layers.surface()) {
    state.draw_surface(mesh, style, matrices, world_to_clip);
  } else {
    state.draw_backdrop(style.background);
    // Lines that the face itself would hide are left out.
    if (!style.layers.transparent) state.draw_depth(state.runs(style.layers), world_to_clip);
  }
  state.draw_lines(style, world_to_clip);
  state.draw_segments(style, world_to_clip, width, height);
  glBindVertexArray(0);
}

}  // namespace aucast::render
