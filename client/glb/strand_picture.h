#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "client/face/face.h"
#include "client/glb/surfaces.h"
#include "client/view/image.h"

namespace aucast::glb {

/// Strands of hair, as the renderer's shader draws them, on a picture that repeats: each column is
/// a strand, lighter and darker in pieces along it. Alpha differs from strand to strand, so that
/// hair that is cut at half (glTF's MASK) frays at its edge. `grey`: white hairs among dark ones.
[[nodiscard]] view::Image strand_picture(bool grey);

/// What hair's own colours are to be multiplied by: on the picture its mean is below 1.
[[nodiscard]] float strand_picture_gain(bool grey);

/// Where the vertices of hair lie on that picture.
[[nodiscard]] std::vector<glm::vec2> strand_places(const face::Face& face, const Surface& surface);

}  // namespace aucast::glb
