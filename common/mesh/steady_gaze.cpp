#include "common/mesh/steady_gaze.h"

#include <algorithm>
#include <utility>

namespace aucast::mesh {
namespace {

double gaze_of(const Measures& measures, bool left) {
  return (left ? measures.left : measures.right)[std::size_t(SideMeasure::GazeLeft)];
}

double median(double a, double b, double c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// `of` with the median gaze of the three.
Measures with_median(Measures of, const Measures& a, const Measures& b, const Measures& c) {
  for (const bool left : {true, false}) {
    (left ? of.left : of.right)[std::size_t(SideMeasure::GazeLeft)] =
        median(gaze_of(a, left), gaze_of(b, left), gaze_of(c, left));
  }
  return of;
}

}  // namespace

void steady_gaze(std::span<Measures> film) {
  if (film.size() < 3) return;
  Measures before = film[0];
  for (std::size_t index = 1; index + 1 < film.size(); ++index) {
    const Measures steady = with_median(film[index], before, film[index], film[index + 1]);
    before = std::exchange(film[index], steady);
  }
}

Measures RunningSteadyGaze::watch(const Measures& seen) {
  last_[watched_++ % last_.size()] = seen;
  return watched_ < last_.size() ? seen : with_median(seen, last_[0], last_[1], last_[2]);
}

}  // namespace aucast::mesh
