#include "client/render/programs.h"

#include <array>
#include <string>
#include <utility>

#include "client/render/uniform_blocks.h"

namespace aucast::render {
namespace {

constexpr const char* kCorePreamble = "#version 330 core\n";
constexpr const char* kEsPreamble =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "precision highp sampler2DShadow;\n";

struct Recipe {
  const char* name;
  Program Programs::*program;
  const char* define;
  const char* vertex;
  const char* fragment;
  std::array<const char*, 3> uniforms{};  ///< those that are set by name; the rest is null
};

constexpr std::array<Recipe, 8> kRecipes{{
    {"surface", &Programs::surface, "#define SURFACE\n", "lit_vertex.glsl", "lit_fragment.glsl"},
    {"hair", &Programs::hair, "#define HAIR\n", "lit_vertex.glsl", "lit_fragment.glsl"},
    {"eye",
     &Programs::eye,
     "#define EYE\n",
     "lit_vertex.glsl",
     "lit_fragment.glsl",
     {"u_eyeball_centre", "u_eyeball_forward", "u_eyeball_open"}},
    {"crease", &Programs::crease, "", "crease_vertex.glsl", "crease_fragment.glsl", {"u_strength"}},
    {"depth", &Programs::depth, "", "depth_vertex.glsl", "depth_fragment.glsl"},
    {"backdrop",
     &Programs::backdrop,
     "",
     "backdrop_vertex.glsl",
     "backdrop_fragment.glsl",
     {"u_centre", "u_edge", "u_square"}},
    {"lines",
     &Programs::lines,
     "",
     "lines_vertex.glsl",
     "lines_fragment.glsl",
     {"u_colour", "u_point_px"}},
    {"segments",
     &Programs::segments,
     "",
     "segment_vertex.glsl",
     "segment_fragment.glsl",
     {"u_alpha"}},
}};

void bind_block(const Program& program, const char* name, GLuint slot) {
  const GLuint index = glGetUniformBlockIndex(program.id(), name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program.id(), index, slot);
}

/// What cannot be written in a text that is both GLSL 3.30 and GLSL ES 3.00.
void bind_inputs(const Program& program) {
  bind_block(program, "Camera", CameraBlock::kSlot);
  bind_block(program, "Lights", LightsBlock::kSlot);
  bind_block(program, "Material", MaterialBlock::kSlot);
  glUseProgram(program.id());
  glUniform1i(glGetUniformLocation(program.id(), "u_shadow_map"), kShadowUnit - GL_TEXTURE0);
  glUniform1i(glGetUniformLocation(program.id(), "u_grain_map"), kGrainUnit - GL_TEXTURE0);
}

Result<void> check_uniforms(const Program& program, const Recipe& recipe) {
  for (const char* name : recipe.uniforms) {
    if (name != nullptr && glGetUniformLocation(program.id(), name) < 0) {
      return Error{ErrorKind::Failed, std::string("the shader \"") + recipe.name +
                                          "\" makes no use of the uniform " + name};
    }
  }
  return {};
}

}  // namespace

Result<Programs> build_programs(const ShaderFiles& files) {
  const auto common = files.text("common.glsl");
  if (!common) return common.error();
  const char* const preamble = is_desktop_gl() ? kCorePreamble : kEsPreamble;
  Programs programs;
  for (const Recipe& recipe : kRecipes) {
    const auto vertex = files.text(recipe.vertex);
    if (!vertex) return vertex.error();
    const auto fragment = files.text(recipe.fragment);
    if (!fragment) return fragment.error();
    const auto pieces = [&](const std::string& stage) {
      // The compiler's words then count the lines of the stage's own file.
      return std::array{preamble, recipe.define, common->c_str(), "#line 1\n", stage.c_str()};
    };
    auto built = build_program(recipe.name, pieces(*vertex), pieces(*fragment));
    if (!built) return built.error();
    if (auto has = check_uniforms(*built, recipe); !has) return has.error();
    bind_inputs(*built);
    programs.*recipe.program = std::move(*built);
  }
  return programs;
}

}  // namespace aucast::render
