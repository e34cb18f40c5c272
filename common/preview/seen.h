#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/action_unit.h"

namespace aucast::preview {

/// The longest side of a picture, in pixels.
inline constexpr std::size_t kSideMax = 320;
/// The most landmarks in one record; no net finds more.
inline constexpr std::size_t kPointsMax = 1000;

/// A place in a picture: 0 to 1 of its width from the left and of its height from the top.
struct Point {
  float x = 0;
  float y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// What a camera sees at one moment.
struct Seen {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;  ///< rows from the top
  std::vector<Point> points;      ///< landmarks; empty: no face is seen
  std::vector<AuTerm> aus;        ///< one for each AU that can be read, 0 % if absent
  friend bool operator==(const Seen&, const Seen&) = default;
};

}  // namespace aucast::preview
