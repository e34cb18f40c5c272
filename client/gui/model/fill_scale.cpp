#include "client/gui/model/fill_scale.h"

#include <algorithm>
#include <cmath>

namespace aucast::gui {

std::size_t fill_scale(const std::vector<float>& history, const BufferBar& buffer) {
  float peak = static_cast<float>(buffer.threshold_percent) / 100;
  for (const float fill : history) peak = std::max(peak, fill);
  // Fills are rounded: 0.07 of 100 sets is no more than 7.
  const float sets = std::floor(peak * static_cast<float>(buffer.capacity) + 0.5F);
  std::size_t top = 5;
  for (std::size_t step = 0; static_cast<float>(top) < sets && top < buffer.capacity; ++step) {
    top = step % 3 == 2 ? top / 2 * 5 : top * 2;
  }
  return std::max<std::size_t>(std::min(top, buffer.capacity), 1);
}

}  // namespace aucast::gui
