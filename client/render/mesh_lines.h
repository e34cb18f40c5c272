#pragma once

#include "client/render/mesh_buffers.h"
#include "client/view/style.h"

namespace aucast::render {

/// Draws the edges and corners of `mesh`, not rounded, with the program `lines`, as far as the
/// style's layers ask for edges or corners. The vertices must be bound.
void draw_mesh_lines(const Program& lines, const MeshBuffers& mesh, const view::Style& style);

}  // namespace aucast::render
