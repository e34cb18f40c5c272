#include "client/gui/model/redraw.h"

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

namespace aucast::gui {
namespace {

/// Ten frames a second are enough to see that time goes on.
constexpr Milliseconds kClockStep{100};

/// What goes on with time, of a model.
struct Passing {
  Duration position;
  std::vector<float> receiver_history;
  std::vector<AuTrace> au_history;
  std::shared_ptr<const preview::Seen> seen;
};

void swap_passing(GuiModel& model, Passing& passing) {
  std::swap(model.local.position, passing.position);
  std::swap(model.playing.receiver_history, passing.receiver_history);
  std::swap(model.playing.au_history, passing.au_history);
  std::swap(model.mirror.seen, passing.seen);
}

}  // namespace

int frames_due(const GuiModel& shown, GuiModel& now) {
  const Duration moved = std::chrono::abs(now.local.position - shown.local.position);
  const bool plays = shown.local.playing && now.local.playing;
  const bool plotted = now.playing.receiver_history != shown.playing.receiver_history ||
                       now.playing.au_history != shown.playing.au_history ||
                       now.mirror.seen != shown.mirror.seen;
  // Put in the place of what is now for the comparison of the rest: far less than a copy of all.
  Passing passing{plays ? shown.local.position : now.local.position, shown.playing.receiver_history,
                  shown.playing.au_history, shown.mirror.seen};
  swap_passing(now, passing);
  const bool changed = now != shown;
  swap_passing(now, passing);
  if (changed) return kFramesAfterChange;
  return moved >= kClockStep || plotted ? 1 : 0;
}

}  // namespace aucast::gui
