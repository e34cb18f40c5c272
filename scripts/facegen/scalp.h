#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {

/// A place inside the head from which the whole scalp can be seen.
inline constexpr Vec3 kInsideHead{0, 3.2, 0.6};

/// Where hair grows. A place of the scalp has two coordinates: s runs round the hairline in
/// [-12, 12), negative on the right; `inside` runs from the hairline (0) to the crown (1).
class Scalp {
 public:
  explicit Scalp(const Identity& who);

  [[nodiscard]] Vec3 hairline(double s) const;
  /// The direction from kInsideHead to the place.
  [[nodiscard]] Vec3 direction(double s, double inside) const;
  [[nodiscard]] Vec3 root(double s, double inside) const;

  /// The nearest point of the hairline.
  struct Edge {
    double distance = 0;
    double place = 0;  ///< |s|, the same on both sides
  };
  [[nodiscard]] Edge edge_from(const Vec3& root) const;

 private:
  const Haircut& cut_;
  Distance head_;
  std::vector<Key<Vec3>> edge_;
};

}  // namespace aucast::facegen
