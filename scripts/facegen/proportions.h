#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// How far `shorten_middle` takes down what is at height `y`; above the cheekbones all of it goes
/// down by the same.
[[nodiscard]] double middle_drop(const Form& form, double y);

/// Takes down nose, eyes, brows and all above, so that the middle of the face is shorter by
/// `short_lip` and `short_nose`. The mouth stays, and with it teeth and muscles.
void shorten_middle(const Form& form, std::vector<Part>& parts);

}  // namespace aucast::facegen
