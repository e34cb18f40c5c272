#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/action_unit.h"

namespace aucast::preview {

/// The longest side of a picture.
inline constexpr std::size_t kSideMax = 320;
/// No net finds more landmarks.
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
  std::vector<Point> points;      ///< landmarks; none: no face is seen
  std::vector<AuTerm> aus;        ///< of every AU that can be seen, even if absent
  friend bool operator==(const Seen&, const Seen&) = default;
};

}  // namespace aucast::preview
