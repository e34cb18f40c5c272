#pragma once

#include <cstdint>

#include "scripts/facegen/identity.h"

namespace aucast::facegen {

/// Somebody who looks a little like `who`: each measure of the form goes some of the way to that of
/// the other people of identity.cpp, or away from it, and the skin is lighter or darker. For
/// training of what reads faces, which must not learn two of them by heart. The same number, the
/// same person; 0 is `who`.
[[nodiscard]] Identity varied(const Identity& who, const Identity& other, std::uint32_t number);

}  // namespace aucast::facegen
