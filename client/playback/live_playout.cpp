#include "client/playback/live_playout.h"

#include <algorithm>
#include <array>
#include <functional>

namespace aucast::playback {
namespace {

constexpr std::int64_t kSecondsKept = 30;
constexpr std::size_t kSpared = 2;
/// Seconds with fewer keyframes than this are not examined for a step of the clock.
constexpr std::size_t kStepKeyframes = 5;
/// For delays in the two computers, such as waking up and reading.
constexpr Duration kMargin = std::chrono::milliseconds(2);
/// delay() is the average over about this many keyframes.
constexpr int kAverageOf = 16;

}  // namespace

Instant LivePlayout::arrived(Instant now, Milliseconds time, std::optional<Milliseconds> place) {
  const bool first = !begin_;
  if (first) begin_ = now;
  // What was left out on the way shows in the places; in a loop they begin again.
  if (place && place_ && *place > *place_ + time) sets_out_ += *place - *place_ - time;
  place_ = place;
  // A client that joins is sent a keyframe that has already begun: it says nothing about the link.
  if (!first) note(now, now - *begin_ - sets_out_);
  sets_out_ += time;
  const Instant due = *begin_ + sets_out_ + latest() + kMargin;
  // What comes too late is played at once, not before.
  const Duration delay = std::max(due - now, Duration::zero());
  delay_ = first ? delay : delay_ + (delay - delay_) / kAverageOf;
  return due;
}

void LivePlayout::note(Instant now, Duration lateness) {
  const std::int64_t number =
      std::chrono::duration_cast<std::chrono::seconds>(now - *begin_).count();
  if (seconds_.empty() || seconds_.back().number != number) {
    forget_before_a_step();
    seconds_.push_back({number, lateness, lateness, 0});
    while (seconds_.front().number <= number - kSecondsKept) seconds_.pop_front();
  }
  Second& second = seconds_.back();
  second.latest = std::max(second.latest, lateness);
  second.earliest = std::min(second.earliest, lateness);
  ++second.keyframes;
}

/// Forgets the seconds before the last complete one if everything in it came later, or earlier,
/// than everything before.
void LivePlayout::forget_before_a_step() {
  if (seconds_.size() < 2 || seconds_.back().keyframes < kStepKeyframes) return;
  const Second over = seconds_.back();
  seconds_.pop_back();
  const auto earlier = [](const Second& one, const Second& other) {
    return one.earliest < other.earliest;
  };
  const Duration earliest = std::min_element(seconds_.begin(), seconds_.end(), earlier)->earliest;
  if (over.earliest > latest() || over.latest < earliest) seconds_.clear();
  seconds_.push_back(over);
}

Duration LivePlayout::latest() const {
  if (seconds_.empty()) return {};
  std::array<Duration, kSecondsKept> sorted{};
  const auto end = std::transform(seconds_.begin(), seconds_.end(), sorted.begin(),
                                  [](const Second& one) { return one.latest; });
  const auto spared = static_cast<std::ptrdiff_t>(std::min(kSpared, seconds_.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + spared, end, std::greater<>());
  return sorted[static_cast<std::size_t>(spared)];
}

}  // namespace aucast::playback
