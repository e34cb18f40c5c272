#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "client/view/image.h"

namespace aucast::test {

/// How two pictures of the same size differ: the share of pixels in which a channel differs by more
/// than a tolerance, and the largest difference.
struct ImageDifference {
  double share = 0;
  int largest = 0;
};
[[nodiscard]] inline ImageDifference compare(const view::Image& a, const view::Image& b,
                                             int tolerance) {
  if (a.width != b.width || a.height != b.height) return {1.0, 255};
  ImageDifference difference;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int largest = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      largest = std::max(largest, std::abs(int{a.rgba[i + c]} - int{b.rgba[i + c]}));
    }
    difference.largest = std::max(difference.largest, largest);
    differing += largest > tolerance ? 1 : 0;
  }
  const std::size_t pixels = a.rgba.size() / 4;
  if (pixels > 0) difference.share = static_cast<double>(differing) / static_cast<double>(pixels);
  return difference;
}

}  // namespace aucast::test
