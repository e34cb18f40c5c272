#pragma once

#include "client/render/gl_objects.h"
#include "client/render/shader_files.h"
#include "common/result.h"

namespace aucast::render {

/// Everything that is drawn with. A lit material has a program of its own, so that no pixel pays
/// for another one.
struct Programs {
  Program surface;
  Program hair;
  Program eye;
  Program crease;
  Program depth;
  Program backdrop;
  Program lines;
  Program segments;
};

constexpr GLenum kShadowUnit = GL_TEXTURE0;
constexpr GLenum kGrainUnit = GL_TEXTURE1;

/// Builds them all as GLSL 3.30 or, in an OpenGL ES context, as GLSL ES 3.00. Failed, with the
/// compiler's words, when one does not build or lacks a uniform that is set.
[[nodiscard]] Result<Programs> build_programs(const ShaderFiles& files);

}  // namespace aucast::render
