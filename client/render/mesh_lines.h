#pragma once

#include "client/render/mesh_buffers.h"
#include "client/view/style.h"

namespace aucast::render {

/// Draws the edges and corners of `mesh`, not rounded, if the style's layers ask for them, with the
/// program `lines`. The vertices must be bound.
void draw_mesh_lines(const Program& lines, const MeshBuffers& mesh, const view::Style& style);

}  // namespace aucast::render
