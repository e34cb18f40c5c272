#pragma once

// OpenGL 3.3 core and OpenGL ES 3.0 through libepoxy; in a browser WebGL 2, which is OpenGL ES 3.0.
#if defined(__EMSCRIPTEN__)
#include <GLES3/gl3.h>
#else
#include <epoxy/gl.h>
#endif

namespace aucast::render {

/// Whether the current context is OpenGL, not OpenGL ES.
[[nodiscard]] inline bool is_desktop_gl() {
#if defined(__EMSCRIPTEN__)
  return false;
#else
  return epoxy_is_desktop_gl();
#endif
}

}  // namespace aucast::render
