#include "client/app/window/input_pacer.h"

#include <set>
#include <utility>

namespace aucast::app {

std::size_t InputPacer::next(const std::deque<render::InputEvent>& waiting, bool typing) {
  using Kind = render::InputEvent::Kind;
  const bool keys_wait = std::exchange(focus_may_move_, false);
  bool moved = false;
  bool clicked = false;
  bool scrolled = false;
  bool acted = false;      // a key was pressed that does not only type
  bool commanded = false;  // what follows may be for what the command opens
  std::set<int> keys;
  std::size_t count = 0;
  for (const render::InputEvent& event : waiting) {
    switch (event.kind) {
      case Kind::Move:
      case Kind::Leave:
        if (clicked || scrolled) return count;
        moved = true;
        break;
      case Kind::Button:
        // A tab is pressed only if the pointer was on it a frame before, and what is dragged goes
        // to where it was let go only if it is seen there.
        if (moved || clicked || scrolled || commanded) return count;
        clicked = true;
        focus_may_move_ = true;
        break;
      case Kind::Scroll:
        if (moved || clicked) return count;
        scrolled = true;
        break;
      case Kind::Key:
        // Letting go goes to nobody, and a key that waits for it would repeat. But a key is seen
        // only while it is down, and so is Ctrl with it.
        if (acted || ((keys_wait || focus_may_move_) && event.action != 0)) return count;
        if (commanded && event.action != 0) return count;
        commanded |= !typing && event.meaning != render::Key::None;
        if (event.text) break;
        if (!keys.insert(event.code).second) return count;
        acted = event.action != 0;
        focus_may_move_ |= acted;
        break;
      case Kind::Character:
        if (keys_wait || focus_may_move_) return count;
        commanded |= !typing && event.meaning != render::Key::None;
        break;
      case Kind::Focus:
        break;
    }
    ++count;
  }
  return count;
}

}  // namespace aucast::app
