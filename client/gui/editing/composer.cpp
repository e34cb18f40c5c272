#include "client/gui/editing/composer.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace aucast::gui {
namespace {

bool same(const Composer::Keyframes& a, const Composer::Keyframes& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one == other || *one == *other;
  });
}

/// How many of the keyframes the others do not share, if they differ in one place.
std::size_t unshared(const Composer::Keyframes& keyframes, const Composer::Keyframes& others) {
  const auto begin =
      std::mismatch(keyframes.begin(), keyframes.end(), others.begin(), others.end());
  const auto end = std::mismatch(keyframes.rbegin(), std::make_reverse_iterator(begin.first),
                                 others.rbegin(), std::make_reverse_iterator(begin.second));
  return static_cast<std::size_t>(end.first.base() - begin.first);
}

float intensity(int percent) {
  return static_cast<float>(std::clamp(percent, 0, 100)) / 100.0F;
}

}  // namespace

const ComposedKeyframe& Composer::current() const {
  return history_.now().chosen ? *history_.now().keyframes[*history_.now().chosen]
                               : history_.now().fresh;
}

bool Composer::unsaved() const {
  return !same(history_.now().keyframes, history_.now().stored);
}

std::size_t Composer::size_of(const State& state, const State& next) {
  const std::size_t alone =
      unshared(state.keyframes, next.keyframes) + unshared(state.stored, next.stored);
  const std::size_t places = state.keyframes.size() + state.stored.size();
  return sizeof(State) + places * sizeof(Keyframes::value_type) + alone * sizeof(ComposedKeyframe);
}

void Composer::step(State next, bool continued) {
  history_.step(std::move(next), continued);
}

void Composer::change_current(const ComposedKeyframe& keyframe, bool continued) {
  if (keyframe == current()) return;
  State next = history_.now();
  if (next.chosen) {
    next.keyframes[*next.chosen] = std::make_shared<const ComposedKeyframe>(keyframe);
  } else {
    next.fresh_touched |= keyframe.aus != next.fresh.aus;
    next.fresh = keyframe;
    if (next.fresh.aus == AuFrame{}) next.fresh_touched = false;
  }
  step(std::move(next), continued);
}

void Composer::set_au(int number, int left_percent, int right_percent, bool continued) {
  if (number < 1 || number > kAuNumberMax) return;
  ComposedKeyframe keyframe = current();
  const auto index = static_cast<std::size_t>(number);
  keyframe.aus.left[index] = intensity(left_percent);
  keyframe.aus.right[index] = intensity(right_percent);
  change_current(keyframe, continued);
}

void Composer::set_aus(const AuFrame& aus, bool continued) {
  ComposedKeyframe keyframe = current();
  keyframe.aus = aus;
  change_current(keyframe, continued);
}

void Composer::set_time(std::optional<std::uint32_t> ms, bool continued) {
  ComposedKeyframe keyframe = current();
  keyframe.ms = ms;
  if (ms) keyframe.ms = std::min(*ms, kMsMax);
  change_current(keyframe, continued);
}

void Composer::add() {
  State next = history_.now();
  const auto added = std::make_shared<const ComposedKeyframe>(current());
  if (next.chosen) {
    next.chosen = *next.chosen + 1;
    next.keyframes.insert(next.keyframes.begin() + static_cast<std::ptrdiff_t>(*next.chosen),
                          added);
  } else {
    next.keyframes.push_back(added);
    next.fresh_touched = false;
  }
  step(std::move(next));
}

void Composer::choose(std::optional<std::size_t> keyframe) {
  if (keyframe && *keyframe >= history_.now().keyframes.size()) return;
  if (keyframe == history_.now().chosen) return;
  State next = history_.now();
  // A new keyframe that was not added is kept until the user comes back to it.
  if (!keyframe && !next.fresh_touched) next.fresh = current();
  next.chosen = keyframe;
  step(std::move(next));
}

void Composer::remove() {
  if (!history_.now().chosen) return;
  State next = history_.now();
  next.keyframes.erase(next.keyframes.begin() + static_cast<std::ptrdiff_t>(*next.chosen));
  if (next.keyframes.empty()) {
    next.chosen.reset();
  } else {
    next.chosen = std::min(*next.chosen, next.keyframes.size() - 1);
  }
  step(std::move(next));
}

void Composer::move(int direction) {
  if (!history_.now().chosen) return;
  const std::size_t from = *history_.now().chosen;
  if (direction < 0 ? from == 0 : from + 1 == history_.now().keyframes.size()) return;
  const std::size_t to = direction < 0 ? from - 1 : from + 1;
  State next = history_.now();
  std::swap(next.keyframes[from], next.keyframes[to]);
  next.chosen = to;
  step(std::move(next));
}

void Composer::load(Keyframes keyframes, std::string file, std::string title) {
  State next;
  next.stored = keyframes;
  next.keyframes = std::move(keyframes);
  next.file = std::move(file);
  next.title = std::move(title);
  if (!next.keyframes.empty()) next.chosen = 0;
  step(std::move(next));
}

void Composer::begin_anew() {
  step({});
}

void Composer::saved(const std::string& file) {
  State& now = history_.now();
  now.stored = now.keyframes;
  now.file = file;
  // The file has changed under every step that was about it: going back to one of them is a change
  // that has not been saved.
  history_.change_others([&](State& state) {
    if (state.file == file) state.stored = now.stored;
  });
}

void Composer::undo() {
  history_.undo();
}

void Composer::redo() {
  history_.redo();
}

}  // namespace aucast::gui
