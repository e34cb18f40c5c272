#pragma once

#include "client/render/gl_objects.h"
#include "client/render/shader_files.h"
#include "common/result.h"

namespace aucast::render {

/// All shader programs. Each lit material has its own, so that no pixel pays for the code of
/// another material.
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

/// Builds all programs as GLSL 3.30 or, in an OpenGL ES context, as GLSL ES 3.00. Fails with the
/// compiler's messages if one does not build or lacks a uniform that is set.
[[nodiscard]] Result<Programs> build_programs(const ShaderFiles& files);

}  // namespace aucast::render
