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

// glGen* and glDelete* are macros over function pointers in libepoxy, hence the small structs.
struct BufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct VertexArrayTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct TextureTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct RenderbufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct FramebufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct ProgramTraits {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

using Buffer = GlObject<BufferTraits>;
using VertexArray = GlObject<VertexArrayTraits>;
using Texture = GlObject<TextureTraits>;
using Renderbuffer = GlObject<RenderbufferTraits>;
using Framebuffer = GlObject<FramebufferTraits>;
using Program = GlObject<ProgramTraits>;

/// Compiles and links. Failed, naming the program and with the compiler's words, when it does not.
/// Each source is given in pieces that are put together.
[[nodiscard]] Result<Program> build_program(const std::string& name,
                                            std::span<const char* const> vertex,
                                            std::span<const char* const> fragment);

/// Where a uniform that the program has is set.
[[nodiscard]] GLint uniform(const Program& program, const char* name);

}  // namespace aucast::render
