#pragma once

#include <array>
#include <optional>

#include "client/render/window.h"
#include "common/time.h"

namespace aucast::app {

/// Judges by the times of two presses whether they are one double click. ImGui 1.86 judges by the
/// frames that saw them, which are further apart if drawing is slow. Pure.
class DoubleClicks {
 public:
  /// Whether this press of a button comes soon enough after the previous press of the same button.
  /// If the exact times are not known, returns true unless the presses were surely too far apart.
  [[nodiscard]] bool follows(const render::InputEvent& press);

 private:
  std::array<std::optional<Instant>, 3> last_{};  ///< InputEvent::by of each button's last press
};

}  // namespace aucast::app
