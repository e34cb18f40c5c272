#pragma once

#include <span>
#include <string>
#include <utility>

#include "client/render/gl.h"
#include "common/result.h"

namespace aucast::render {

/// An OpenGL name that is deleted with its owner. The context must be current then.
template <typename Traits>
class GlObject {
 public:
  GlObject() : id_(Traits::create()) {}
  explicit GlObject(GLuint id) : id_(id) {}
  ~GlObject() {
    if (id_ != 0) Traits::destroy(id_);
  }
  GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  [[nodiscard]] GLuint id() const { return id_; }

 private:
  GLuint id_;
};

/// Traits for a kind of object whose names are made by `kGenerate` and deleted by `kDelete`: OpenGL
/// functions, or libepoxy's pointers to them.
template <auto& kGenerate, auto& kDelete>
struct NamedTraits {
  static GLuint create() {
    GLuint id = 0;
    kGenerate(1, &id);
    return id;
  }
  static void destroy(GLuint id) { kDelete(1, &id); }
};
struct ProgramTraits {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

using Buffer = GlObject<NamedTraits<glGenBuffers, glDeleteBuffers>>;
using VertexArray = GlObject<NamedTraits<glGenVertexArrays, glDeleteVertexArrays>>;
using Texture = GlObject<NamedTraits<glGenTextures, glDeleteTextures>>;
using Renderbuffer = GlObject<NamedTraits<glGenRenderbuffers, glDeleteRenderbuffers>>;
using Framebuffer = GlObject<NamedTraits<glGenFramebuffers, glDeleteFramebuffers>>;
using Program = GlObject<ProgramTraits>;

/// Compiles and links a program. On failure the error has `name` and the compiler's messages. Each
/// source is given in pieces that are put together.
[[nodiscard]] Result<Program> build_program(const std::string& name,
                                            std::span<const char* const> vertex,
                                            std::span<const char* const> fragment);

/// The location of a uniform. The program must have it.
[[nodiscard]] GLint uniform(const Program& program, const char* name);

}  // namespace aucast::render
