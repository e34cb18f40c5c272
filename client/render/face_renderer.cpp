#include "client/render/face_renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "client/render/gl_objects.h"
#include "client/render/shaders.h"
#include "client/view/camera.h"
#include "common/check.h"

namespace aucast::render {
namespace {

using view::Shading;

// Directions towards the lights (face.md 5); they stay with the head's room, not with the camera.
const glm::vec3 kKeyDirection = glm::normalize(glm::vec3(-0.45F, 0.55F, 0.75F));
const glm::vec3 kFillDirection = glm::normalize(glm::vec3(0.85F, 0.10F, 0.55F));
const glm::vec3 kRimDirection = glm::normalize(glm::vec3(0.65F, 0.45F, -0.75F));
const glm::vec3 kSecondRimDirection = glm::normalize(glm::vec3(-0.80F, 0.30F, -0.60F));

/// The key light's shadows cover a fixed box, so that they do not crawl while the head moves. A
/// texel of 0.07 units under a filter of three gives the soft edge of a large lamp.
constexpr int kShadowSide = 384;
constexpr glm::vec3 kShadowCentre{0, 0, 1};
constexpr float kShadowReach = 13;
constexpr float kShadowBias = 0.08F;
constexpr float kShadowSlopeBias = 2.0F;

constexpr GLuint kPositionSlot = 0;
constexpr GLuint kNormalSlot = 1;
constexpr GLuint kColourSlot = 2;
constexpr GLuint kOcclusionGlossSlot = 3;

enum class Faces : std::uint8_t { Both, Front, Back };

/// How a kind of surface answers the light; values from face.md 5.
struct Look {
  float wrap = 1;
  float specular = 0;
  float power = 20;
  Faces faces = Faces::Both;
  bool casts_shadow = false;
  float shadow_kept = 0;
};

Look look_of(Shading shading) {
  switch (shading) {
    case Shading::Skin:
      return {1.0F, 0.19F, 20, Faces::Front, true};
    case Shading::Eye:
      return {0.25F, 0, 60, Faces::Front, false};
    case Shading::Teeth:
      // Teeth behind a lip are lit through and from all sides; in true shadow they look grey.
      return {0.8F, 0.5F, 40, Faces::Both, false, 0.5F};
    case Shading::Mouth:
      return {0.7F, 0.4F, 24, Faces::Both, false};
    case Shading::Hair:
      return {0.35F, 0.20F, 14, Faces::Both, true};
    case Shading::Cloth:
      return {0.15F, 0.06F, 8, Faces::Both, true};
    case Shading::Brow:
      return {0.2F, 0.05F, 10, Faces::Both, false};
    case Shading::Crease:
      return {};  // has a program of its own
  }
  return {};
}

/// A run of indices with one look.
struct Draw {
  Shading shading = Shading::Skin;
  Faces faces = Faces::Both;
  int index = -1;  ///< of the eye or the crease
  std::size_t first_index = 0;
  GLsizei index_count = 0;
};

int index_of(const view::ShadedRange& range) {
  if (range.shading == Shading::Crease) return range.crease;
  return range.shading == Shading::Eye ? range.eye : -1;
}

/// Outermost first, so that what lies beneath is never shaded: hair over skin over eyes and teeth.
/// The inside of the hair, seen only from below, comes last.
void order_solids(std::vector<Draw>& draws) {
  const auto layer = [](const Draw& draw) {
    switch (draw.shading) {
      case Shading::Hair:
        return draw.faces == Faces::Back ? 4 : 0;
      case Shading::Cloth:
        return 1;
      case Shading::Skin:
        return 2;
      default:
        return 3;
    }
  };
  std::vector<Draw> insides;
  for (Draw& draw : draws) {
    if (draw.shading != Shading::Hair) continue;
    draw.faces = Faces::Front;
    insides.push_back(draw);
    insides.back().faces = Faces::Back;
  }
  draws.insert(draws.end(), insides.begin(), insides.end());
  std::stable_sort(draws.begin(), draws.end(),
                   [&layer](const Draw& a, const Draw& b) { return layer(a) < layer(b); });
}

class LitProgram {
 public:
  explicit LitProgram(Program program) : program_(std::move(program)) {
    const auto find = [this](const char* name) {
      return glGetUniformLocation(program_.id(), name);
    };
    world_to_clip_ = find("u_world_to_clip");
    world_to_shadow_ = find("u_world_to_shadow");
    eye_ = find("u_eye");
    wrap_ = find("u_wrap");
    specular_ = find("u_specular");
    power_ = find("u_power");
    shadow_kept_ = find("u_shadow_kept");
    eyeball_centre_ = find("u_eyeball_centre");
    eyeball_forward_ = find("u_eyeball_forward");
    glUseProgram(program_.id());
    const auto set = [&find](const char* name, const glm::vec3& value) {
      glUniform3fv(find(name), 1, glm::value_ptr(value));
    };
    set("u_key_direction", kKeyDirection);
    set("u_fill_direction", kFillDirection);
    set("u_rim_direction", kRimDirection);
    set("u_second_rim_direction", kSecondRimDirection);
    glUniform1i(find("u_shadow_map"), 0);
    glUniform2f(find("u_shadow_texel"), 1.0F / kShadowSide, 1.0F / kShadowSide);
  }

  void set_camera(const glm::mat4& world_to_clip, const glm::mat4& world_to_shadow,
                  const glm::vec3& eye) {
    glUseProgram(program_.id());
    glUniformMatrix4fv(world_to_clip_, 1, GL_FALSE, glm::value_ptr(world_to_clip));
    glUniformMatrix4fv(world_to_shadow_, 1, GL_FALSE, glm::value_ptr(world_to_shadow));
    glUniform3fv(eye_, 1, glm::value_ptr(eye));
  }

  void use(const Look& look) {
    glUseProgram(program_.id());
    glUniform1f(wrap_, look.wrap);
    glUniform1f(specular_, look.specular);
    glUniform1f(power_, look.power);
    glUniform1f(shadow_kept_, look.shadow_kept);
  }

  void set_eyeball(const glm::vec3& centre, const glm::vec3& forward) {
    glUniform3fv(eyeball_centre_, 1, glm::value_ptr(centre));
    glUniform3fv(eyeball_forward_, 1, glm::value_ptr(forward));
  }

 private:
  Program program_;
  GLint world_to_clip_ = -1;
  GLint world_to_shadow_ = -1;
  GLint eye_ = -1;
  GLint wrap_ = -1;
  GLint specular_ = -1;
  GLint power_ = -1;
  GLint shadow_kept_ = -1;
  GLint eyeball_centre_ = -1;
  GLint eyeball_forward_ = -1;
};

Result<Program> build_lit(const char* name, const char* define) {
  namespace glsl = shaders;
  return build_program(name, std::array{glsl::kVersion, define, glsl::kLitVertex},
                       std::array{glsl::kVersion, define, glsl::kTone, glsl::kLitFragment});
}

void attribute(GLuint slot, GLint components) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

template <typename T>
void upload(GLenum target, std::span<const T> data, GLenum usage) {
  glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
}

/// The light's own view of the box, and the way into its depth texture.
struct ShadowMatrices {
  glm::mat4 world_to_clip;
  glm::mat4 world_to_texture;
};

ShadowMatrices shadow_matrices() {
  const glm::mat4 view =
      glm::lookAt(kShadowCentre + kKeyDirection * kShadowReach, kShadowCentre, glm::vec3(0, 1, 0));
  const glm::mat4 projection =
      glm::ortho(-kShadowReach, kShadowReach, -kShadowReach, kShadowReach, 0.0F, 2 * kShadowReach);
  glm::mat4 to_texture =
      glm::translate(glm::mat4(1), glm::vec3(0.5F, 0.5F, 0.5F - kShadowBias / (2 * kShadowReach)));
  to_texture = glm::scale(to_texture, glm::vec3(0.5F));
  return {projection * view, to_texture * projection * view};
}

}  // namespace

struct FaceRenderer::State {
  LitProgram surface;
  LitProgram hair;
  LitProgram eye;
  Program crease;
  Program depth;
  Program backdrop;
  VertexArray vertices;
  VertexArray no_vertices;
  Buffer positions;
  Buffer normals;
  Buffer colours;
  Buffer occlusion_gloss;
  Buffer indices;
  Texture shadow_texture;
  Framebuffer shadow_framebuffer;
  ShadowMatrices shadow = shadow_matrices();

  std::size_t vertex_count = 0;
  std::vector<Draw> solid;
  std::vector<Draw> translucent;
  std::vector<Draw> creases;

  State(Program surface_program, Program hair_program, Program eye_program, Program crease_program,
        Program depth_program, Program backdrop_program)
      : surface(std::move(surface_program)),
        hair(std::move(hair_program)),
        eye(std::move(eye_program)),
        crease(std::move(crease_program)),
        depth(std::move(depth_program)),
        backdrop(std::move(backdrop_program)) {}

  void set_up();
  [[nodiscard]] LitProgram& program_for(Shading shading);
  void draw_shadow_map();
  void draw_backdrop(const view::Background& background);
  void draw_runs(const std::vector<Draw>& draws, const view::MovingMesh& mesh);
  void draw_creases(std::span<const float> strengths, const glm::mat4& world_to_clip,
                    const glm::vec3& eye_place);
};

void FaceRenderer::State::set_up() {
  glBindVertexArray(vertices.id());
  const std::array<std::pair<const Buffer*, std::pair<GLuint, GLint>>, 4> attributes{
      {{&positions, {kPositionSlot, 3}},
       {&normals, {kNormalSlot, 3}},
       {&colours, {kColourSlot, 4}},
       {&occlusion_gloss, {kOcclusionGlossSlot, 2}}}};
  for (const auto& [buffer, layout] : attributes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer->id());
    attribute(layout.first, layout.second);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
  glBindVertexArray(0);

  glBindTexture(GL_TEXTURE_2D, shadow_texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kShadowSide, kShadowSide, 0,
               GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  // Outside the box everything is lit.
  const std::array<GLfloat, 4> farthest{1, 1, 1, 1};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);

  GLint framebuffer_before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_before);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shadow_framebuffer.id());
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                         shadow_texture.id(), 0);
  glDrawBuffer(GL_NONE);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer_before));
}

LitProgram& FaceRenderer::State::program_for(Shading shading) {
  if (shading == Shading::Hair) return hair;
  return shading == Shading::Eye ? eye : surface;
}

void FaceRenderer::State::draw_shadow_map() {
  GLint framebuffer_before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_before);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shadow_framebuffer.id());
  glViewport(0, 0, kShadowSide, kShadowSide);
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(depth.id());
  glUniformMatrix4fv(glGetUniformLocation(depth.id(), "u_world_to_clip"), 1, GL_FALSE,
                     glm::value_ptr(shadow.world_to_clip));
  glDisable(GL_CULL_FACE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kShadowSlopeBias, 0);
  for (const Draw& draw : solid) {
    if (!look_of(draw.shading).casts_shadow || draw.faces == Faces::Back) continue;
    glDrawElements(GL_TRIANGLES, draw.index_count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(draw.first_index * sizeof(std::uint32_t)));
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer_before));
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
    program.use(look);
    if (draw.index >= 0) {
      const auto at = static_cast<std::size_t>(draw.index);
      AUCAST_CHECK(at < mesh.eye_centres.size() && at < mesh.eye_forward.size());
      program.set_eyeball(mesh.eye_centres[at], mesh.eye_forward[at]);
    }
    if (draw.faces == Faces::Both) {
      glDisable(GL_CULL_FACE);
    } else {
      glEnable(GL_CULL_FACE);
      glCullFace(draw.faces == Faces::Front ? GL_BACK : GL_FRONT);
    }
    glDrawElements(GL_TRIANGLES, draw.index_count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(draw.first_index * sizeof(std::uint32_t)));
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
    glDrawElements(GL_TRIANGLES, draw.index_count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(draw.first_index * sizeof(std::uint32_t)));
  }
  glDepthMask(GL_TRUE);
}

FaceRenderer::FaceRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
FaceRenderer::~FaceRenderer() = default;

Result<std::unique_ptr<FaceRenderer>> FaceRenderer::create() {
  namespace glsl = shaders;
  auto surface = build_lit("surface", glsl::kAsSurface);
  if (!surface.has_value()) return surface.error();
  auto hair = build_lit("hair", glsl::kAsHair);
  if (!hair.has_value()) return hair.error();
  auto eye = build_lit("eye", glsl::kAsEye);
  if (!eye.has_value()) return eye.error();
  auto crease = build_program("crease", std::array{glsl::kVersion, glsl::kCreaseVertex},
                              std::array{glsl::kVersion, glsl::kCreaseFragment});
  if (!crease.has_value()) return crease.error();
  auto depth = build_program("shadow", std::array{glsl::kVersion, glsl::kDepthVertex},
                             std::array{glsl::kVersion, glsl::kDepthFragment});
  if (!depth.has_value()) return depth.error();
  auto backdrop = build_program("backdrop", std::array{glsl::kVersion, glsl::kBackdropVertex},
                                std::array{glsl::kVersion, glsl::kTone, glsl::kBackdropFragment});
  if (!backdrop.has_value()) return backdrop.error();
  auto state = std::make_unique<State>(std::move(surface.value()), std::move(hair.value()),
                                       std::move(eye.value()), std::move(crease.value()),
                                       std::move(depth.value()), std::move(backdrop.value()));
  state->set_up();
  return std::unique_ptr<FaceRenderer>(new FaceRenderer(std::move(state)));
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
  std::vector<std::array<std::uint32_t, 3>> sorted;
  sorted.reserve(mesh.triangles.size());
  state.solid.clear();
  state.translucent.clear();
  state.creases.clear();
  const auto clear_corner = [&mesh](const std::array<std::uint32_t, 3>& triangle) {
    return mesh.colours[triangle[0]].a < 1 || mesh.colours[triangle[1]].a < 1 ||
           mesh.colours[triangle[2]].a < 1;
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
      const Draw draw{range.shading, look_of(range.shading).faces, index_of(range), 3 * first,
                      static_cast<GLsizei>(3 * count)};
      (crease ? state.creases : blended ? state.translucent : state.solid).push_back(draw);
    }
  }
  order_solids(state.solid);

  glBindVertexArray(state.vertices.id());
  glBindBuffer(GL_ARRAY_BUFFER, state.colours.id());
  upload(GL_ARRAY_BUFFER, mesh.colours, GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, state.occlusion_gloss.id());
  upload(GL_ARRAY_BUFFER, std::span<const glm::vec2>(occlusion_gloss), GL_STATIC_DRAW);
  upload(GL_ELEMENT_ARRAY_BUFFER, std::span<const std::array<std::uint32_t, 3>>(sorted),
         GL_STATIC_DRAW);
}

void FaceRenderer::draw(const view::MovingMesh& mesh, const view::Camera& camera,
                        const view::Background& background, int width, int height) {
  State& state = *state_;
  AUCAST_CHECK(mesh.positions.size() == state.vertex_count);
  AUCAST_CHECK(mesh.normals.size() == state.vertex_count);
  glBindVertexArray(state.vertices.id());
  glBindBuffer(GL_ARRAY_BUFFER, state.positions.id());
  upload(GL_ARRAY_BUFFER, mesh.positions, GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, state.normals.id());
  upload(GL_ARRAY_BUFFER, mesh.normals, GL_STREAM_DRAW);

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glFrontFace(GL_CCW);
  state.draw_shadow_map();

  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const view::CameraMatrices matrices = view::camera_matrices(camera, width, height);
  const glm::mat4 world_to_clip = matrices.projection * matrices.view;
  for (LitProgram* program : {&state.surface, &state.hair, &state.eye}) {
    program->set_camera(world_to_clip, state.shadow.world_to_texture, matrices.eye);
  }
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, state.shadow_texture.id());
  state.draw_runs(state.solid, mesh);
  state.draw_backdrop(background);

  glEnable(GL_BLEND);
  state.draw_creases(mesh.creases, world_to_clip, matrices.eye);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  // Brows and lashes lie on the skin.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -1);
  state.draw_runs(state.translucent, mesh);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace aucast::render
