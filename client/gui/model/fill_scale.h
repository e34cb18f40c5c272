#pragma once

#include <cstddef>
#include <vector>

#include "client/gui/model/gui_model.h"

namespace aucast::gui {

/// How many sets the top of a buffer's chart stands for: the least of 5, 10, 20, 50, 100 and so on
/// that has room for the buffer's threshold and its `history` (fills in [0,1] of its capacity), but
/// at most the capacity. Steps keep the chart from jumping often. Pure.
[[nodiscard]] std::size_t fill_scale(const std::vector<float>& history, const BufferBar& buffer);

}  // namespace aucast::gui
