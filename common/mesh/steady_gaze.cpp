#include "common/mesh/steady_gaze.h"

#include <algorithm>
#include <utility>

namespace aucast::mesh {
namespace {

/// So that there is a mean of eyes that are shut in all three pictures.
constexpr double kLeastOpen = 0.01;

/// `of` with the mean gaze of three pictures, one after the other.
Measures with_mean(Measures of, const Measures& before, const Measures& at, const Measures& after) {
  for (const auto side : {&Measures::left, &Measures::right}) {
    double sum = 0;
    double weights = 0;
    for (const auto& [picture, times] : {std::pair(&before, 1.0), {&at, 2.0}, {&after, 1.0}}) {
      const auto& eye = picture->*side;
      const double weight = times * std::max(eye[std::size_t(SideMeasure::Aperture)], kLeastOpen);
      sum += weight * eye[std::size_t(SideMeasure::GazeLeft)];
      weights += weight;
    }
    (of.*side)[std::size_t(SideMeasure::GazeLeft)] = sum / weights;
  }
  return of;
}

}  // namespace

void steady_gaze(std::span<Measures> film) {
  if (film.size() < 3) return;
  Measures before = film[0];
  for (std::size_t index = 1; index + 1 < film.size(); ++index) {
    const Measures steady = with_mean(film[index], before, film[index], film[index + 1]);
    before = std::exchange(film[index], steady);
  }
}

Measures RunningSteadyGaze::watch(const Measures& seen) {
  std::rotate(last_.begin(), last_.begin() + 1, last_.end());
  last_.back() = seen;
  return ++watched_ < last_.size() ? seen : with_mean(seen, last_[0], last_[1], last_[2]);
}

}  // namespace aucast::mesh
