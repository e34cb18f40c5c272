#include "client/app/video/shot.h"

#include <algorithm>
#include <limits>

namespace aucast::app {

view::Viewpoint viewpoint_of(view::ViewpointPreset preset, const face::Face& face) {
  view::Viewpoint viewpoint = view::portrait_viewpoint(preset);
  if (face.classic) {
    // Waters' mask has its own height and nothing around it.
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    for (const glm::vec3& p : face.mesh.positions) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
    viewpoint.target.y = (low + high) / 2;
    viewpoint.half_height = std::max(0.1F, (high - low) * 0.55F);
  }
  return viewpoint;
}

view::Background backdrop(std::optional<std::uint32_t> rgb, bool transparent) {
  if (!rgb) return {.transparent = transparent};
  // The inverse of the renderer's tone curve (to_screen() in client/render/shaders/common.glsl).
  const auto linear = [rgb](unsigned shift) {
    const float value = static_cast<float>((*rgb >> shift) & 255U) / 255.0F;
    return value * value / (1.0F - 0.14F * value * value);
  };
  const glm::vec3 colour{linear(16), linear(8), linear(0)};
  return {colour, colour, transparent};
}

}  // namespace aucast::app
