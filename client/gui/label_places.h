#pragma once

#include <vector>

namespace aucast::gui {

/// Where labels stand that belong to these heights: each as close to its own as can be, in the same
/// order, `gap` apart and between `top` and `bottom`. With less room than that they stand evenly.
/// Pure.
[[nodiscard]] std::vector<float> label_places(const std::vector<float>& wanted, float gap,
                                              float top, float bottom);

}  // namespace aucast::gui
