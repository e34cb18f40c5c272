#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace aucast::view {

/// A rectangle of the desktop, which may reach over several screens.
struct ScreenArea {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// The screen that shows most of the window; the first one if none shows any of it. `screens`: at
/// least one.
[[nodiscard]] inline std::size_t screen_of(const ScreenArea& window,
                                           std::span<const ScreenArea> screens) {
  const auto common = [&window](const ScreenArea& screen) {
    const int width =
        std::min(window.x + window.width, screen.x + screen.width) - std::max(window.x, screen.x);
    const int height =
        std::min(window.y + window.height, screen.y + screen.height) - std::max(window.y, screen.y);
    return std::int64_t{std::max(width, 0)} * std::max(height, 0);
  };
  const auto most = std::max_element(
      screens.begin(), screens.end(),
      [&](const ScreenArea& a, const ScreenArea& b) { return common(a) < common(b); });
  return static_cast<std::size_t>(most - screens.begin());
}

}  // namespace aucast::view
