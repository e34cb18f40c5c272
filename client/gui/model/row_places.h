#pragma once

#include <vector>

namespace aucast::gui {

/// A row of a panel that scrolls: which one it is, and where it begins, from the top of all rows.
struct RowPlace {
  unsigned id = 0;
  float y = 0;
};

/// How far the row at the height `at` has moved down from one frame to the next, as the nearest row
/// above it tells that is there in both. Rows whose ID is there more than once do not count. 0: not
/// at all, or no row tells. Pure.
[[nodiscard]] float moved_down(const std::vector<RowPlace>& before,
                               const std::vector<RowPlace>& now, float at);

}  // namespace aucast::gui
