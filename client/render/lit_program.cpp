#include "client/render/lit_program.h"

#include <array>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "client/render/shaders.h"

namespace aucast::render {
namespace {

// Directions towards the lights beside the key (face.md 5); they stay with the head's room, not
// with the camera.
const glm::vec3 kFillDirection = glm::normalize(glm::vec3(0.85F, 0.10F, 0.55F));
const glm::vec3 kRimDirection = glm::normalize(glm::vec3(0.65F, 0.45F, -0.75F));
const glm::vec3 kSecondRimDirection = glm::normalize(glm::vec3(-0.80F, 0.30F, -0.60F));

}  // namespace

Result<LitProgram> LitProgram::create(const char* name, const char* define) {
  namespace glsl = shaders;
  auto program = build_program(name, std::array{glsl::kVersion, define, glsl::kLitVertex},
                               std::array{glsl::kVersion, define, glsl::kTone, glsl::kLitFragment});
  if (!program.has_value()) return program.error();
  return LitProgram(std::move(program.value()));
}

LitProgram::LitProgram(Program program) : program_(std::move(program)) {
  const auto find = [this](const char* name) { return glGetUniformLocation(program_.id(), name); };
  world_to_clip_ = find("u_world_to_clip");
  world_to_shadow_ = find("u_world_to_shadow");
  key_direction_ = find("u_key_direction");
  key_strength_ = find("u_key_strength");
  eye_ = find("u_eye");
  wrap_ = find("u_wrap");
  specular_ = find("u_specular");
  power_ = find("u_power");
  shadow_kept_ = find("u_shadow_kept");
  grain_ = find("u_grain");
  eyeball_centre_ = find("u_eyeball_centre");
  eyeball_forward_ = find("u_eyeball_forward");
  eyeball_open_ = find("u_eyeball_open");
  glUseProgram(program_.id());
  const auto set = [&find](const char* name, const glm::vec3& value) {
    glUniform3fv(find(name), 1, glm::value_ptr(value));
  };
  set("u_fill_direction", kFillDirection);
  set("u_rim_direction", kRimDirection);
  set("u_second_rim_direction", kSecondRimDirection);
  glUniform1i(find("u_shadow_map"), 0);
  glUniform1i(find("u_grain_map"), 1);
}

void LitProgram::set_camera(const glm::mat4& world_to_clip, const glm::mat4& world_to_shadow,
                            const glm::vec3& eye) {
  glUseProgram(program_.id());
  glUniformMatrix4fv(world_to_clip_, 1, GL_FALSE, glm::value_ptr(world_to_clip));
  glUniformMatrix4fv(world_to_shadow_, 1, GL_FALSE, glm::value_ptr(world_to_shadow));
  glUniform3fv(eye_, 1, glm::value_ptr(eye));
}

void LitProgram::set_key_light(const glm::vec3& towards, float strength) {
  glUseProgram(program_.id());
  glUniform3fv(key_direction_, 1, glm::value_ptr(towards));
  glUniform1f(key_strength_, strength);
}

void LitProgram::use(const Answer& answer) {
  glUseProgram(program_.id());
  glUniform1f(wrap_, answer.wrap);
  glUniform1f(specular_, answer.specular);
  glUniform1f(power_, answer.power);
  glUniform1f(shadow_kept_, answer.shadow_kept);
  glUniform1f(grain_, answer.grain);
}

void LitProgram::set_eyeball(const glm::vec3& centre, const glm::vec3& forward, float open) {
  glUniform3fv(eyeball_centre_, 1, glm::value_ptr(centre));
  glUniform3fv(eyeball_forward_, 1, glm::value_ptr(forward));
  glUniform1f(eyeball_open_, open);
}

}  // namespace aucast::render
