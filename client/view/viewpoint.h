#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "client/view/scene.h"

namespace aucast::view {

/// What a renderer needs of a viewpoint for a picture of one shape; "eye" is where it stands.
struct ViewMatrices {
  glm::mat4 view{1};        ///< world to eye, looking down -z
  glm::mat4 projection{1};  ///< eye to OpenGL's clip space, depth -1 to 1
  glm::vec3 eye{0};         ///< world
};

/// Sizes below 1 count as 1. A picture narrower than 0.87 of its height sees as much in width as
/// one of that shape, so that a face is never cut at its sides, its head tilted or not.
[[nodiscard]] ViewMatrices view_matrices(const Viewpoint& viewpoint, int width, int height);

enum class ViewpointPreset : std::uint8_t { Front, ThreeQuarter, Profile };

/// "front", "three-quarter", "profile"; nothing for another word.
[[nodiscard]] std::optional<ViewpointPreset> viewpoint_preset(std::string_view name);

/// A portrait of the whole head at rest. The side views show the subject's right, where the key
/// light comes from.
[[nodiscard]] Viewpoint portrait_viewpoint(ViewpointPreset preset);

/// Turns about the target by a drag in pixels of a picture of that height; half a turn is one
/// height. The pitch stays within 80 degrees.
void orbit(Viewpoint& viewpoint, double right_px, double down_px, int height);

/// Moves the target so that what is under the pointer follows a drag in pixels.
void pan(Viewpoint& viewpoint, double right_px, double down_px, int height);

/// Comes closer by a tenth a step (negative: goes away), between a detail of an eye and a figure.
void zoom(Viewpoint& viewpoint, double steps);

}  // namespace aucast::view
