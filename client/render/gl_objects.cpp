#include "client/render/gl_objects.h"

#include <vector>

#include "common/check.h"
#include "common/text.h"

namespace aucast::render {
namespace {

constexpr std::size_t kWordsShown = 400;

Error broken(const std::string& name, const char* step, std::string words) {
  while (!words.empty() && (words.back() == '\n' || words.back() == '\0')) words.pop_back();
  return {ErrorKind::Failed, "the graphics driver refuses to " + std::string(step) +
                                 " the shader \"" + name + "\": " + escaped(words, kWordsShown)};
}

/// Compiles one stage into `program`; the shader lives on in the program only.
Result<void> attach(GLuint program, const std::string& name, GLenum stage,
                    std::span<const char* const> pieces) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, static_cast<GLsizei>(pieces.size()), pieces.data(), nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::string words;
  if (compiled != GL_TRUE) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    words.resize(static_cast<std::size_t>(length));
    glGetShaderInfoLog(shader, length, nullptr, words.data());
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);
  if (compiled != GL_TRUE) return broken(name, "compile", words);
  return {};
}

}  // namespace

Result<Program> build_program(const std::string& name, std::span<const char* const> vertex,
                              std::span<const char* const> fragment) {
  Program program;
  if (auto done = attach(program.id(), name, GL_VERTEX_SHADER, vertex); !done.has_value()) {
    return done.error();
  }
  if (auto done = attach(program.id(), name, GL_FRAGMENT_SHADER, fragment); !done.has_value()) {
    return done.error();
  }
  glLinkProgram(program.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  GLint length = 0;
  glGetProgramiv(program.id(), GL_INFO_LOG_LENGTH, &length);
  std::string words(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(program.id(), length, nullptr, words.data());
  return broken(name, "link", words);
}

GLint uniform(const Program& program, const char* name) {
  const GLint location = glGetUniformLocation(program.id(), name);
  AUCAST_CHECK(location >= 0);
  return location;
}

}  // namespace aucast::render
