#pragma once

#include <string>
#include <vector>

#include "common/action_unit.h"

namespace aucast::gui {

/// A prototype's place on the emotion pad, which has the two axes of thesis figure 3.3: x from sad
/// (-1) to happy (+1), y from calm (-1) to excited (+1).
struct PadPoint {
  std::string label;
  float x = 0;
  float y = 0;
  AuFrame aus;
  friend bool operator==(const PadPoint&, const PadPoint&) = default;
};

/// The AUs for a place on the pad: neutral in the middle, a prototype at its own place. Elsewhere
/// they are a mixture of two prototypes, the nearest on either side of the direction from the
/// middle to the place, scaled by the distance from the middle. Intensities are whole percent, as
/// in streams. Without points, returns the neutral face.
[[nodiscard]] AuFrame pad_face(const std::vector<PadPoint>& points, float x, float y);

}  // namespace aucast::gui
