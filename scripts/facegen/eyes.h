#pragma once

#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// An eyeball: side 1 left, -1 right. Its rings lie exactly on pupil, iris and limbus.
[[nodiscard]] Part make_eye(int side);

}  // namespace aucast::facegen
