#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "scripts/facegen/maths.h"

namespace aucast::facegen {

/// A line through two points or more, no two neighbours of them in one place: in the front plane
/// (glm::dvec2), in the front plane with a strength as z of each (Vec3), or in space (Vec3). The
/// points must outlive it.
template <typename Point>
class Polyline {
 public:
  explicit constexpr Polyline(std::span<const Point> points) : points_(points) {}

  /// A place on one of the straight pieces.
  struct Place {
    std::size_t piece = 0;
    double share = 0;    ///< of the piece, from its beginning
    double away = 0;     ///< how far from there the point is that was asked for
    double to_left = 0;  ///< how far it is to the left of the piece's direction; negative: right

    /// The way from the beginning in pieces: 1.5 in the middle of the second one.
    [[nodiscard]] double along() const { return static_cast<double>(piece) + share; }
  };

  /// The place that is nearest to `p`, seen from the front.
  [[nodiscard]] Place nearest(const glm::dvec2& p) const {
    Place best;
    best.away = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Place place = nearest_on(i, p);
      if (place.away < best.away) best = place;
    }
    return best;
  }

  /// The strength of the line at `p`: its own where `p` lies on it, beside it falling off as bell()
  /// of `width`. Of several pieces the one counts that gives most.
  [[nodiscard]] double strength(const glm::dvec2& p, double width) const {
    double most = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const Place place = nearest_on(i, p);
      const double own = mix(points_[i].z, points_[i + 1].z, place.share);
      most = std::max(most, own * bell(place.away, width));
    }
    return most;
  }

  [[nodiscard]] double length() const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) sum += length_of(i);
    return sum;
  }

  /// The point that is `way` from the beginning, measured along the straight pieces; an end beyond
  /// the ends.
  [[nodiscard]] Point at_length(double way) const {
    if (way <= 0) return points_.front();
    double begin = 0;
    double end = length_of(0);
    std::size_t i = 0;
    while (end < way && i + 2 < points_.size()) {
      begin = end;
      end += length_of(++i);
    }
    const double share = saturate((way - begin) / (end - begin));
    return points_[i] + (points_[i + 1] - points_[i]) * share;
  }

  /// The point at `share` of the way, from 0 to 1, on the smooth curve through the points; from
  /// each to the next it is the same share.
  [[nodiscard]] Point along(double share) const {
    const auto last = static_cast<double>(points_.size() - 1);
    return curve_through(
        points_.size(), [last](std::size_t i) { return static_cast<double>(i) / last; },
        [this](std::size_t i) { return points_[i]; }, share);
  }

 private:
  [[nodiscard]] Place nearest_on(std::size_t i, const glm::dvec2& p) const {
    const glm::dvec2 begin{points_[i]};
    const glm::dvec2 edge = glm::dvec2{points_[i + 1]} - begin;
    const glm::dvec2 from_begin = p - begin;
    const double share = saturate(glm::dot(from_begin, edge) / glm::dot(edge, edge));
    return {i, share, glm::length(from_begin - edge * share),
            glm::dot(from_begin, glm::dvec2{-edge.y, edge.x}) / glm::length(edge)};
  }

  [[nodiscard]] double length_of(std::size_t i) const {
    return glm::length(points_[i + 1] - points_[i]);
  }

  std::span<const Point> points_;
};

template <typename Points>
Polyline(const Points&) -> Polyline<typename Points::value_type>;

}  // namespace aucast::facegen
