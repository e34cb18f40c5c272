#pragma once

#include <string>

#include "scripts/facegen/identity.h"
#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// All parts of a person's head, skin first, made stage by stage. Deterministic. Fails with BadData
/// if the measures give no head: some place would be no finite number.
[[nodiscard]] Result<std::vector<Part>> make_head(const Identity& who);

/// The bytes of mesh.ply (data/faces/FORMAT.md).
[[nodiscard]] std::string head_file(const std::vector<Part>& parts);

}  // namespace aucast::facegen
