#include "scripts/facegen/scalp.h"

namespace aucast::facegen {

Scalp::Scalp(const Identity& who) : cut_(who.hair), head_(head_of(who)) {
  for (int i = -240; i < 240; ++i) edge_.push_back({std::abs(i) / 20.0, root(i / 20.0, 0)});
}

Vec3 Scalp::hairline(double s) const {
  Vec3 p = sample<Vec3>(cut_.hairline, std::abs(s));
  if (s < 0) p.x = -p.x;
  return p;
}

Vec3 Scalp::direction(double s, double inside) const {
  const Vec3 from = glm::normalize(hairline(s) - kInsideHead);
  const Vec3 to = glm::normalize(cut_.crown - kInsideHead);
  const double whole = std::acos(std::clamp(glm::dot(from, to), -1.0, 1.0));
  const double way = inside < 0 ? inside : power(inside, 1.2);
  return glm::normalize((from * std::sin((1 - way) * whole) + to * std::sin(way * whole)) /
                        std::sin(whole));
}

Vec3 Scalp::root(double s, double inside) const {
  return leave(kInsideHead, direction(s, inside), head_);
}

Scalp::Edge Scalp::edge_from(const Vec3& root) const {
  Edge nearest{1e9, 0};
  for (const Key<Vec3>& point : edge_) {
    const double distance = glm::length(point.value - root);
    if (distance < nearest.distance) nearest = {distance, point.at};
  }
  return nearest;
}

}  // namespace aucast::facegen
