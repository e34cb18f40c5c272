#pragma once

#include "client/render/mesh_buffers.h"
#include "client/view/style.h"

namespace aucast::render {

/// If the style's layers ask for them, draws the edges and corners of `mesh`, not rounded, with the
/// program `lines`. The vertices must be bound.
void draw_mesh_lines(const Program& lines, const MeshBuffers& mesh, const view::Style& style);

}  // namespace aucast::render
