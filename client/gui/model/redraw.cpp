#include "client/gui/model/redraw.h"

#include <chrono>

namespace aucast::gui {
namespace {

/// Ten frames a second are enough to see that time goes on.
constexpr Milliseconds kClockStep{100};

}  // namespace

int frames_due(const GuiModel& shown, GuiModel now) {
  const Duration moved = std::chrono::abs(now.local.position - shown.local.position);
  const bool plays = shown.local.playing && now.local.playing;
  if (plays) now.local.position = shown.local.position;
  const bool plotted = now.playing.receiver_history != shown.playing.receiver_history ||
                       now.playing.au_history != shown.playing.au_history ||
                       now.mirror.seen != shown.mirror.seen;
  now.playing.receiver_history = shown.playing.receiver_history;
  now.playing.au_history = shown.playing.au_history;
  now.mirror.seen = shown.mirror.seen;
  if (now != shown) return kFramesAfterChange;
  return moved >= kClockStep || plotted ? 1 : 0;
}

}  // namespace aucast::gui
