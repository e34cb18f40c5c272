#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// Makes the mirrored head a little uneven, as every face is: brow, mouth, nose and jaw differ by
/// `askew` between left and right. Smooth, so that no part parts from another; the lids, what is
/// inside the mouth and the hair stay.
void make_uneven(const Askew& askew, std::vector<Part>& parts);

}  // namespace aucast::facegen
