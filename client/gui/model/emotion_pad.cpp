#include "client/gui/model/emotion_pad.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aucast::gui {
namespace {

/// Closer to the middle than this, the direction means nothing and the face is neutral.
constexpr float kMiddle = 1e-3F;

struct Polar {
  const PadPoint* point = nullptr;
  float angle = 0;
  float radius = 0;
};

/// The counter-clockwise angle from `from` to `to`, in [0, 2 pi).
float turn(float from, float to) {
  const float whole = 2 * std::numbers::pi_v<float>;
  const float way = std::fmod(to - from, whole);
  return way < 0 ? way + whole : way;
}

float percent(float intensity) {
  return std::round(std::clamp(intensity, 0.0F, 1.0F) * 100) / 100;
}

}  // namespace

AuFrame pad_face(const std::vector<PadPoint>& points, float x, float y) {
  AuFrame face;
  const float radius = std::hypot(x, y);
  if (radius < kMiddle) return face;
  const float angle = std::atan2(y, x);
  Polar before;
  Polar after;
  for (const PadPoint& point : points) {
    const Polar polar{&point, std::atan2(point.y, point.x), std::hypot(point.x, point.y)};
    if (polar.radius < kMiddle) continue;
    if (before.point == nullptr || turn(polar.angle, angle) < turn(before.angle, angle)) {
      before = polar;
    }
    // A point in exactly this direction is `before`; as `after` it is a whole turn away.
    const auto ahead = [&](const Polar& one) {
      const float way = turn(angle, one.angle);
      return way == 0 ? 2 * std::numbers::pi_v<float> : way;
    };
    if (after.point == nullptr || ahead(polar) < ahead(after)) after = polar;
  }
  if (before.point == nullptr) return face;
  const float between = turn(before.angle, after.angle);
  const float share = between > 0 ? turn(before.angle, angle) / between : 0;
  const float reach = before.radius + share * (after.radius - before.radius);
  const float strength = std::min(1.0F, radius / reach);
  for (std::size_t i = 1; i < face.left.size(); ++i) {
    const auto mixed = [&](float first, float second) {
      return percent(strength * (first + share * (second - first)));
    };
    face.left[i] = mixed(before.point->aus.left[i], after.point->aus.left[i]);
    face.right[i] = mixed(before.point->aus.right[i], after.point->aus.right[i]);
  }
  return face;
}

}  // namespace aucast::gui
