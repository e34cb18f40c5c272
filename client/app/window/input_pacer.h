#pragma once

#include <cstddef>
#include <deque>

#include "client/render/window.h"

namespace aucast::app {

/// Shares input out among frames. ImGui 1.86 looks at the state of mouse and keys once a frame, so
/// that with slow drawing a tap would be lost, a click would land where the pointer went
/// afterwards, and keys would go to what had the focus before the click. Pure.
class InputPacer {
 public:
  /// How many events, from the front of `waiting`, the next frame may see; may be none when keys
  /// have to wait until it is known who gets them.
  [[nodiscard]] std::size_t next(const std::deque<render::InputEvent>& waiting);

 private:
  bool focus_may_move_ = false;  ///< by what the frame before saw
};

}  // namespace aucast::app
