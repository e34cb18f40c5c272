#include "scripts/facegen/scalp.h"

namespace aucast::facegen {

Scalp::Scalp(const Identity& who) : cut_(who.hair), head_(head_of(who)) {}

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

}  // namespace aucast::facegen
