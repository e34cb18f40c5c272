#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {

/// A place from which the whole scalp is seen.
inline constexpr Vec3 kInsideHead{0, 3.2, 0.6};

/// Where hair grows: s runs round the hairline in [-12, 12), negative on the right; `inside` from
/// the hairline (0) to the crown (1).
class Scalp {
 public:
  explicit Scalp(const Identity& who);

  [[nodiscard]] Vec3 hairline(double s) const;
  /// From inside the head through the place.
  [[nodiscard]] Vec3 direction(double s, double inside) const;
  [[nodiscard]] Vec3 root(double s, double inside) const;

  struct Edge {
    double distance = 0;
    double place = 0;  ///< the nearest of the hairline, the same to both sides
  };
  [[nodiscard]] Edge edge_from(const Vec3& root) const;

 private:
  const Haircut& cut_;
  Distance head_;
  std::vector<Key<Vec3>> edge_;
};

}  // namespace aucast::facegen
