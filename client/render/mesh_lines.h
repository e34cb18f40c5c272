#pragma once

#include <span>

#include "client/render/mesh_buffers.h"
#include "client/view/style.h"

namespace aucast::render {

/// Draws the edges and corners of `runs` as far as the style's layers ask for them, with the
/// program `lines` and the vertices that are bound. Nothing in OpenGL ES, which cannot fill
/// triangles with lines.
void draw_mesh_lines(const Program& lines, std::span<const Run> runs, const view::Style& style);

}  // namespace aucast::render
