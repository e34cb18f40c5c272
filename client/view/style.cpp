#include "client/view/style.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/text.h"

namespace aucast::view {

Result<Layers> parse_layers(std::string_view text) {
  Layers layers;
  layers.textured = false;
  for (const std::string_view word : split(text, ',')) {
    const auto* const found = std::find_if(kLayerNames.begin(), kLayerNames.end(),
                                           [&](const LayerName& one) { return one.name == word; });
    if (found == kLayerNames.end()) {
      return Error{ErrorKind::Usage, "'" + escaped(word) + "' is not one of " + layer_names()};
    }
    layers.*found->member = true;
  }
  if (layers.transparent && !layers.polygons) layers.textured = true;
  return layers;
}

std::string layer_names() {
  std::string names;
  for (const LayerName& one : kLayerNames) {
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  }
  return names;
}

std::string format_layers(const Layers& layers) {
  std::string text;
  for (const LayerName& one : kLayerNames) {
    if (!(layers.*one.member)) continue;
    text += (text.empty() ? "" : ",") + std::string(one.name);
  }
  return text;
}

KeyLight key_light(float yaw_deg, float pitch_deg, float strength) {
  constexpr float kRadPerDeg = std::numbers::pi_v<float> / 180;
  const float yaw = yaw_deg * kRadPerDeg;
  const float pitch = std::clamp(pitch_deg, -80.0F, 80.0F) * kRadPerDeg;
  return {{std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)},
          strength};
}

float line_scale(int height_px) {
  constexpr float kUsualHeight = 800;
  return std::clamp(static_cast<float>(height_px) / kUsualHeight, 0.5F, 4.0F);
}

}  // namespace aucast::view
