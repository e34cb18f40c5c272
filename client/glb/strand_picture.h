#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "client/face/face.h"
#include "client/glb/surfaces.h"
#include "client/view/image.h"

namespace aucast::glb {

/// A tileable picture of strands of hair, as the renderer's shader draws them: each column is a
/// strand with lighter and darker stretches. Alpha differs from strand to strand, so that hair
/// whose alpha is cut at one half (glTF's MASK) frays at its edge. `grey`: white hairs among dark
/// ones.
[[nodiscard]] view::Image strand_picture(bool grey);

/// The factor by which to multiply hair's own colours, because the picture's mean is below 1.
[[nodiscard]] float strand_picture_gain(bool grey);

/// The texture coordinates of the vertices of hair on that picture.
[[nodiscard]] std::vector<glm::vec2> strand_coordinates(const face::Face& face,
                                                        const Surface& surface);

}  // namespace aucast::glb
