#pragma once

#include <array>
#include <cstddef>

#include "client/app/window/double_clicks.h"
#include "client/render/window.h"

namespace aucast::app {

/// The mouse as the panels see it.
class PanelMouse {
 public:
  /// Takes a Move, a Leave or a press or release of a button.
  void take(const render::InputEvent& event);
  /// Passes the mouse's state on to ImGui, for the next frame.
  void hand_over() const;
  [[nodiscard]] bool down(std::size_t button) const { return buttons_[button]; }
  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double y() const { return y_; }

 private:
  /// The position of a pointer that has left the window.
  static constexpr double kNowhere = -1e6;

  DoubleClicks double_clicks_;
  double x_ = kNowhere;
  double y_ = kNowhere;
  std::array<bool, 3> buttons_{};
  bool follows_ = false;  ///< the last press came soon enough after another for a double click
};

}  // namespace aucast::app
