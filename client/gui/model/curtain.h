#pragma once

#include <optional>

#include "common/time.h"

namespace aucast::gui {

/// Decides whether the panels are hidden. In full screen they are hidden when the mouse has been
/// still for a while, and come back when it moves; in a window they stay. Pure: times are handed
/// in.
class Curtain {
 public:
  /// How long the mouse must be still before the panels are hidden.
  static constexpr Milliseconds kTime{3'000};

  void set_full_screen(bool full_screen, Instant now) {
    full_screen_ = full_screen;
    touched_at_ = now;
  }
  [[nodiscard]] bool full_screen() const { return full_screen_; }
  /// Call it when the mouse was moved or pressed, or something is open or being typed.
  void touched(Instant now) { touched_at_ = now; }
  [[nodiscard]] bool hides(Instant now) const { return full_screen_ && now - touched_at_ >= kTime; }
  /// When hides() will become true if nothing is touched until then; nullopt: never, or it is true
  /// already.
  [[nodiscard]] std::optional<Instant> falls_at(Instant now) const {
    if (!full_screen_ || hides(now)) return std::nullopt;
    return touched_at_ + kTime;
  }

 private:
  bool full_screen_ = false;
  Instant touched_at_{};
};

}  // namespace aucast::gui
