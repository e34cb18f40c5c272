#pragma once

#include <string>

#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// All parts of the head, skin first, made stage by stage. Deterministic.
[[nodiscard]] std::vector<Part> make_head();

/// The bytes of mesh.ply (data/faces/README.md).
[[nodiscard]] std::string head_file(const std::vector<Part>& parts);

}  // namespace aucast::facegen
