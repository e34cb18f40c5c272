#pragma once

#include <vector>

namespace aucast::gui {

/// The heights at which to place labels: each as close to its wanted height as possible, in the
/// same order, at least `gap` apart and between `top` and `bottom`. If there is not enough room
/// they are spread evenly. Pure.
[[nodiscard]] std::vector<float> label_places(const std::vector<float>& wanted, float gap,
                                              float top, float bottom);

}  // namespace aucast::gui
