#pragma once

#include <string>
#include <vector>

#include "common/action_unit.h"

namespace aucast::gui {

/// A prototype's place on the two emotional axes of thesis figure 3.3: sad (-1) to happy (+1), calm
/// (-1) to excited (+1).
struct PadPoint {
  std::string label;
  float x = 0;
  float y = 0;
  AuFrame aus;
  friend bool operator==(const PadPoint&, const PadPoint&) = default;
};

/// The face of a place on the pad: neutral in the middle, a prototype at its own place, and between
/// two of them by direction and by the distance from the middle. In whole percent, as streams have
/// it. Without points it is the neutral face.
[[nodiscard]] AuFrame pad_face(const std::vector<PadPoint>& points, float x, float y);

}  // namespace aucast::gui
