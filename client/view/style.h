#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "client/view/scene.h"
#include "common/result.h"

namespace aucast::view {

/// What is drawn of a face, in any combination (thesis figure 5.6).
struct Layers {
  bool polygons = false;     ///< the surface in one plain colour
  bool textured = true;      ///< the surface in its own colours; takes precedence over `polygons`
  bool transparent = false;  ///< what is behind the surface shows through it
  bool wireframe = false;
  bool vertices = false;
  bool muscles = false;   ///< with attachment, insertion, zone of influence and fall-off radii
  bool jaw_tags = false;  ///< vertices that the jaw carries, coloured by their weight
  bool eye_tags = false;  ///< vertices of the lids, coloured by how far they move
  friend bool operator==(const Layers&, const Layers&) = default;

  [[nodiscard]] bool surface() const { return polygons || textured; }
};

/// A layer by its name on the command line and in the settings.
struct LayerName {
  std::string_view name;
  bool Layers::*member;
};
inline constexpr std::array<LayerName, 8> kLayerNames{{{"polygons", &Layers::polygons},
                                                       {"textured", &Layers::textured},
                                                       {"transparent", &Layers::transparent},
                                                       {"wireframe", &Layers::wireframe},
                                                       {"vertices", &Layers::vertices},
                                                       {"muscles", &Layers::muscles},
                                                       {"jaw-tags", &Layers::jaw_tags},
                                                       {"eye-tags", &Layers::eye_tags}}};

/// Reads a list such as "muscles,wireframe": exactly these are drawn, except that "transparent"
/// without a surface adds "textured". Any other word is a Usage error, which names all layers.
[[nodiscard]] Result<Layers> parse_layers(std::string_view text);
/// All layers as a message lists them: "polygons, textured, ...".
[[nodiscard]] std::string layer_names();
/// The list that parse_layers() reads.
[[nodiscard]] std::string format_layers(const Layers& layers);

/// The key light: the direction towards it, in the coordinates of the mesh, and its strength (1:
/// the default).
struct KeyLight {
  glm::vec3 direction{-0.51F, 0.56F, 0.653F};
  float strength = 1;
  friend bool operator==(const KeyLight&, const KeyLight&) = default;
};

/// The key light at `yaw_deg` to the subject's left and `pitch_deg` up. The pitch is clamped to -80
/// to 80.
[[nodiscard]] KeyLight key_light(float yaw_deg, float pitch_deg, float strength);

/// A straight line of constant width in the picture; a dot if both ends are the same.
struct Segment {
  glm::vec3 from{0};
  glm::vec3 to{0};
  glm::vec4 colour{1};  ///< sRGB and alpha
  float width_px = 1;   ///< at scale 1; a dot's diameter
};

/// How a face is drawn. Spans borrow from the caller.
struct Style {
  Background background = {};
  Layers layers = {};
  KeyLight light = {};
  float scale = 1;  ///< factor for the width of lines and dots, such as 2 for a picture of twice
                    ///< the resolution
  std::span<const Segment> diagram = {};  ///< shines faintly through the surface
  std::span<const Segment> tags = {};     ///< hidden by the surface
};

/// Style::scale for a picture this high: lines grow with large pictures, and are no thinner than
/// usual in small ones.
[[nodiscard]] float line_scale(int height_px);

}  // namespace aucast::view
