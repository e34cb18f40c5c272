#pragma once

namespace aucast::glb {

/// glTF is in metres; a unit of a face's mesh is 1.4 cm (data/faces/README.md). The axes agree.
inline constexpr float kMetresPerUnit = 0.014F;

}  // namespace aucast::glb
