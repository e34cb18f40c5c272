#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// Makes the mirrored head a little uneven, as every face is: brow, mouth, nose and jaw differ by
/// `askew` between left and right. The shift is smooth, so that parts stay together. Eyes, lids,
/// teeth, tongue, hair and shirt stay where they are.
void make_uneven(const Askew& askew, std::vector<Part>& parts);

}  // namespace aucast::facegen
