#pragma once

#include <cstdint>

#include "client/view/scene.h"

namespace aucast::render {

enum class Faces : std::uint8_t { Both, Front };

/// How a kind of surface answers the light; values from face.md 5.
struct Look {
  float wrap = 1;
  float specular = 0;
  float power = 20;
  Faces faces = Faces::Both;
  bool casts_shadow = false;
  float shadow_kept = 0;
  float grain = 0;
};

[[nodiscard]] Look look_of(view::Shading shading);

}  // namespace aucast::render
