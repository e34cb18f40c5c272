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

/// What is drawn of a face, any combination at once (thesis figure 5.6).
struct Layers {
  bool polygons = false;     ///< the surface in one plain colour
  bool textured = true;      ///< the surface in its own colours; wins over the plain one
  bool transparent = false;  ///< the surface lets through what is behind it
  bool wireframe = false;
  bool vertices = false;
  bool muscles = false;   ///< with attachment, insertion, zone of influence and fall-off radii
  bool jaw_tags = false;  ///< vertices that the jaw carries, coloured by their weight
  bool eye_tags = false;  ///< vertices of the lids, coloured by their way
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

/// "muscles,wireframe": exactly these, except that transparent alone means the textured surface.
/// Usage error, naming them all, for another word; BadData never.
[[nodiscard]] Result<Layers> parse_layers(std::string_view text);
/// The other way round.
[[nodiscard]] std::string format_layers(const Layers& layers);

/// The key light: towards it, in the head's room, and how strong it is (1 is the studio's).
struct KeyLight {
  glm::vec3 direction{-0.45F, 0.55F, 0.75F};
  float strength = 1;
  friend bool operator==(const KeyLight&, const KeyLight&) = default;
};

/// The key light that stands `yaw_deg` to the subject's left and `pitch_deg` up, -80 to 80.
[[nodiscard]] KeyLight key_light(float yaw_deg, float pitch_deg, float strength);

/// A straight line in the picture, as wide everywhere; a dot when both ends are the same.
struct Segment {
  glm::vec3 from{0};
  glm::vec3 to{0};
  glm::vec4 colour{1};  ///< as on the screen, alpha
  float width_px = 1;   ///< of a picture at scale 1; a dot's diameter
};

/// How a face is drawn. Spans borrow from the caller.
struct Style {
  Background background = {};
  Layers layers = {};
  KeyLight light = {};
  float scale = 1;                        ///< of lines and dots: 2 for a picture twice as fine
  std::span<const Segment> diagram = {};  ///< shines through the surface, faintly
  std::span<const Segment> tags = {};     ///< hidden by the surface
};

}  // namespace aucast::view
