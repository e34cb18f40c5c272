#pragma once

#include <vector>

namespace aucast::gui {

/// A row of a panel that scrolls: which one it is, and where it begins, from the top of all rows.
struct RowPlace {
  unsigned id = 0;
  float y = 0;
};

/// How far the row at the height `at` has moved down from one frame to the next. This is measured
/// at the nearest row above it that is in both frames; rows whose ID is not unique do not count. 0:
/// the row has not moved, or there is no row to measure at. Pure.
[[nodiscard]] float moved_down(const std::vector<RowPlace>& before,
                               const std::vector<RowPlace>& now, float at);

}  // namespace aucast::gui
