#pragma once

#include "common/action_unit.h"

namespace aucast::face {

/// "left", "right" or "both", as in messages and files.
[[nodiscard]] constexpr const char* side_word(Side side) {
  return side == Side::Left ? "left" : side == Side::Right ? "right" : "both";
}

}  // namespace aucast::face
