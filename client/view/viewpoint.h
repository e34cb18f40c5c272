#pragma once

#include <cstdint>
#include <string_view>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/view/scene.h"

namespace aucast::view {

/// A viewpoint as matrices, for a picture of a given shape. "eye" is where the viewpoint is.
struct ViewMatrices {
  glm::mat4 view{1};        ///< world to eye, looking down -z
  glm::mat4 projection{1};  ///< eye to OpenGL's clip space, depth -1 to 1
  glm::vec3 eye{0};         ///< world
};

/// Sizes below 1 count as 1. A picture narrower than 0.87 of its height shows as much from side to
/// side as one whose width is 0.87 of its height, so that a face, even tilted, is never cut at its
/// sides.
[[nodiscard]] ViewMatrices view_matrices(const Viewpoint& viewpoint, int width, int height);

enum class ViewpointPreset : std::uint8_t { Front, ThreeQuarter, Profile };

/// "front", "three-quarter" or "profile".
[[nodiscard]] std::string_view name(ViewpointPreset preset);

/// The viewpoint for a portrait of the whole neutral head. The side views show the subject's right,
/// where the key light comes from.
[[nodiscard]] Viewpoint portrait_viewpoint(ViewpointPreset preset);

/// Turns the viewpoint about its target by a drag in pixels. `height`: the picture's; a drag over
/// all of it is half a turn. The pitch stays within 80 degrees.
void orbit(Viewpoint& viewpoint, double right_px, double down_px, int height);

/// Moves the target so that what is under the pointer follows a drag in pixels.
void pan(Viewpoint& viewpoint, double right_px, double down_px, int height);

/// Comes closer by a tenth per step (negative: goes away), within limits: from a detail of an eye
/// to a whole figure.
void zoom(Viewpoint& viewpoint, double steps);

}  // namespace aucast::view
