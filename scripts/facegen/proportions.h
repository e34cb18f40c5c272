#pragma once

#include <vector>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// How far `shorten_middle` lowers what is at height `y`; above the cheekbones everything goes down
/// by the same amount.
[[nodiscard]] double middle_drop(const Form& form, double y);

/// Lowers nose, eyes, brows and all above, so that the middle of the face is shorter by
/// `short_lip` + `short_nose`. The mouth stays, and with it teeth and muscles.
void shorten_middle(const Form& form, std::vector<Part>& parts);

}  // namespace aucast::facegen
