#include "client/playback/keyframe_buffers.h"

#include <algorithm>
#include <utility>

#include "common/check.h"

namespace aucast::playback {
namespace {

/// By time: what must be there to play without waiting for each keyframe.
constexpr std::size_t kKeyframesMin = 2;
constexpr int kFasterPercent = 95;
constexpr int kSlowerPercent = 105;

/// The longest delay that stalls lead to: a link that needs more cannot carry the stream, and a
/// longer wait would not end its stalls.
constexpr Milliseconds kDelayAfterStallsMax{10'000};

/// Of a recorded stream. Twice the delay is enough after a few stalls whatever the link needs, and
/// no stall shortens a delay that was longer from the beginning.
Milliseconds delay_after_stall(Milliseconds delay) {
  return std::max(delay, std::min(delay * 2, kDelayAfterStallsMax));
}

}  // namespace

KeyframeBuffers::KeyframeBuffers(BufferOptions options)
    : options_(options), queue_(options.receiver_capacity, options.playout_capacity) {
  AUCAST_CHECK(options.receiver_capacity >= 1 &&
               options.receiver_capacity <= BufferOptions::kSetsMax);
  AUCAST_CHECK(options.playout_capacity >= 1);
  AUCAST_CHECK(options.playout_capacity <= options.receiver_capacity);
  AUCAST_CHECK(options.threshold_percent >= 1 && options.threshold_percent <= 100);
  AUCAST_CHECK(options.live_delay >= Milliseconds::zero() &&
               options.live_delay <= BufferOptions::kDelayMax);
  set_live(false);
}

void KeyframeBuffers::set_live(bool live) {
  if (live) {
    kind_ = options_.low_delay ? Kind::LiveLowDelay : Kind::Live;
  } else {
    kind_ = options_.by_time ? Kind::RecordedByTime : Kind::Recorded;
  }
}

void KeyframeBuffers::set_delay(Milliseconds delay) {
  options_.live_delay = std::clamp(delay, Milliseconds::zero(), BufferOptions::kDelayMax);
}

KeyframeBuffers::Stored KeyframeBuffers::store(const Keyframe& keyframe) {
  if (kind_ == Kind::Recorded || kind_ == Kind::RecordedByTime) return store_recorded(keyframe);
  store_live(keyframe);
  return Stored::Yes;
}

KeyframeBuffers::Stored KeyframeBuffers::store_recorded(const Keyframe& keyframe) {
  const bool full = room() == 0;
  if (full && has_next()) return Stored::No;  // case A
  if (full) release();                        // case B

  // Case D compares before it stores, as figure 5.13 does; a threshold of the whole receiver is
  // therefore reached by case B.
  const bool reached = ended_ || receiver_fill() >= threshold_of(options_);
  queue_.push(keyframe);  // all but case A
  if (kind_ == Kind::Recorded ? reached : !waiting_ || enough()) release();
  return Stored::Yes;
}

void KeyframeBuffers::store_live(const Keyframe& keyframe) {
  if (room() == 0) drop();
  queue_.push(keyframe);
  if (waiting_) catch_up();
  // A full receiver takes nothing more, so that waiting on would never end.
  if (!waiting_ || room() == 0 || enough()) release();
}

void KeyframeBuffers::catch_up() {
  const bool low_delay = kind_ == Kind::LiveLowDelay;
  if (buffered() <= wanted() + (low_delay ? kStandingLagMax : kLiveLagMax)) return;
  const std::size_t least = low_delay ? 1 : kKeyframesMin;
  while (queue_.size() > least && buffered() > wanted()) drop();
}

void KeyframeBuffers::drop() {
  queue_.drop();
  ++dropped_;
}

Milliseconds KeyframeBuffers::wanted() const {
  if (kind_ == Kind::Live) return options_.live_delay;
  const Keyframe& newest = queue_.newest();
  if (!newest.due || !newest.arrived) return queue_.time_of(newest);
  return std::chrono::ceil<Milliseconds>(*newest.due - *newest.arrived);
}

bool KeyframeBuffers::enough() const {
  if (ended_ || kind_ == Kind::LiveLowDelay) return true;
  return queue_.size() >= kKeyframesMin && buffered() >= options_.live_delay;
}

void KeyframeBuffers::end_of_stream() {
  ended_ = true;
  release();
}

std::optional<Keyframe> KeyframeBuffers::take() {
  if (!has_next()) {
    const bool stall = !std::exchange(waiting_, true) && !ended_;
    if (stall && kind_ == Kind::RecordedByTime && options_.adapt) {
      options_.live_delay = delay_after_stall(options_.live_delay);
    }
    return std::nullopt;
  }
  waiting_ = false;
  std::optional<Keyframe> keyframe(queue_.pop());
  if (kind_ == Kind::Live) keyframe->pace_percent = pace_percent(queue_.time_of(*keyframe));
  return keyframe;
}

int KeyframeBuffers::pace_percent(Milliseconds time) const {
  if (buffered() > options_.live_delay + time) return kFasterPercent;
  return options_.adapt && buffered() + 2 * time < options_.live_delay ? kSlowerPercent : 100;
}

}  // namespace aucast::playback
