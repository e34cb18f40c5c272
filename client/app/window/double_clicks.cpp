#include "client/app/window/double_clicks.h"

#include <cstddef>
#include <utility>

namespace aucast::app {
namespace {

/// As on most desktops.
constexpr Milliseconds kDoubleClick{400};

}  // namespace

bool DoubleClicks::follows(const render::InputEvent& press) {
  const auto button = static_cast<std::size_t>(press.code);
  if (press.code < 0 || button >= last_.size()) return false;
  const std::optional<Instant> before = std::exchange(last_[button], press.by);
  return before && press.after - *before < kDoubleClick;
}

}  // namespace aucast::app
