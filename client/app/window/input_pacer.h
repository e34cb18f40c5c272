#pragma once

#include <cstddef>
#include <deque>

#include "client/render/window.h"

namespace aucast::app {

/// Distributes input over frames. ImGui 1.86 looks at the state of mouse and keys once a frame. If
/// drawing is slow, without this class a tap would be lost, a click would land where the pointer
/// went afterwards, and keys would go to what had the focus before the click. Pure.
class InputPacer {
 public:
  /// How many events, from the front of `waiting`, the next frame may see. 0 if keys have to wait
  /// until it is known which item gets them. `typing`: a text is being typed, so that no key is a
  /// command.
  [[nodiscard]] std::size_t next(const std::deque<render::InputEvent>& waiting, bool typing);

 private:
  bool focus_may_move_ = false;  ///< because of what the previous frame saw
};

}  // namespace aucast::app
