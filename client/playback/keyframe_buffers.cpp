#include "client/playback/keyframe_buffers.h"

#include <algorithm>

#include "common/check.h"

namespace aucast::playback {
namespace {

/// Live: what must be there to play without waiting for each keyframe.
constexpr std::size_t kLiveKeyframesMin = 2;
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

KeyframeBuffers::KeyframeBuffers(BufferOptions options) : options_(options) {
  AUCAST_CHECK(options.receiver_capacity >= 1 &&
               options.receiver_capacity <= BufferOptions::kSetsMax);
  AUCAST_CHECK(options.playout_capacity >= 1);
  AUCAST_CHECK(options.playout_capacity <= options.receiver_capacity);
  AUCAST_CHECK(options.threshold_percent >= 1 && options.threshold_percent <= 100);
  AUCAST_CHECK(options.live_delay >= Milliseconds::zero() &&
               options.live_delay <= BufferOptions::kDelayMax);
}

void KeyframeBuffers::set_live(std::optional<Milliseconds> untimed) {
  live_ = untimed;
}

KeyframeBuffers::Stored KeyframeBuffers::store(const Keyframe& keyframe) {
  if (live_) {
    store_live(keyframe);
    return Stored::Yes;
  }
  const bool full = room() == 0;
  const bool playing = has_next();
  if (full && playing) return Stored::No;  // case A
  if (full) fill_playout();                // case B

  // Case D compares before it stores, as figure 5.13 does; a threshold of the whole receiver is
  // therefore reached by case B.
  const bool start = !full && !playing && (ended_ || receiver_fill() >= threshold_of(options_));
  append(keyframe);  // all but case A
  if (options_.by_time ? !playing && (!starved_ || enough()) : start) fill_playout();
  return Stored::Yes;
}

void KeyframeBuffers::set_delay(Milliseconds delay) {
  options_.live_delay = std::clamp(delay, Milliseconds::zero(), BufferOptions::kDelayMax);
}

bool KeyframeBuffers::enough() const {
  if (ended_) return true;
  if (live_ && options_.low_delay) return !keyframes_.empty();
  return keyframes_.size() >= kLiveKeyframesMin && buffered() >= options_.live_delay;
}

void KeyframeBuffers::store_live(const Keyframe& keyframe) {
  append(keyframe);
  drop_oldest();
  // A full receiver takes nothing more, so that waiting on would never end.
  if (starved_ && room() > 0 && !enough()) return;
  if (!has_next()) fill_playout();
}

void KeyframeBuffers::drop_oldest() {
  // The receiver's oldest follows into the Playout buffer: one is lost, whatever that holds.
  const auto drop_one = [this] {
    remove_first();
    playout_ = std::min(playout_, keyframes_.size());
    ++dropped_;
  };
  while (receiver_fill() > options_.receiver_capacity) drop_one();
  const Milliseconds lag = options_.low_delay ? kStandingLagMax : kLiveLagMax;
  if (!starved_ || buffered() <= wanted() + lag) return;
  const std::size_t least = options_.low_delay ? 1 : kLiveKeyframesMin;
  while (keyframes_.size() > least && buffered() > wanted()) drop_one();
}

Milliseconds KeyframeBuffers::wanted() const {
  if (!options_.low_delay) return options_.live_delay;
  const Keyframe& newest = keyframes_.back();
  if (!newest.due || !newest.arrived) return time_of(newest);
  return std::chrono::ceil<Milliseconds>(*newest.due - *newest.arrived);
}

Milliseconds KeyframeBuffers::time_of(const Keyframe& keyframe) const {
  return keyframe.time.value_or(live_.value_or(untimed_));
}

Milliseconds KeyframeBuffers::buffered() const {
  return timed_ + live_.value_or(untimed_) * untimed_count_;
}

std::size_t KeyframeBuffers::room() const {
  return options_.receiver_capacity - receiver_fill();
}

void KeyframeBuffers::release() {
  if (!has_next()) fill_playout();
}

void KeyframeBuffers::end_of_stream() {
  ended_ = true;
  release();
}

std::optional<Keyframe> KeyframeBuffers::take() {
  if (!has_next()) {
    const bool stall = begun_ && !starved_ && !ended_;
    if (stall && options_.adapt && options_.by_time && !live_) {
      options_.live_delay = delay_after_stall(options_.live_delay);
    }
    starved_ = true;
    return std::nullopt;
  }
  starved_ = false;
  begun_ = true;
  std::optional<Keyframe> keyframe(keyframes_.front());
  pop_front();
  if (!has_next()) fill_playout();
  const Milliseconds time = time_of(*keyframe);
  if (!live_ || options_.low_delay) return keyframe;
  const Milliseconds ahead = buffered();
  if (ahead > options_.live_delay + time) {
    keyframe->pace_percent = kFasterPercent;
  } else if (options_.adapt && ahead + 2 * time < options_.live_delay) {
    keyframe->pace_percent = kSlowerPercent;
  }
  return keyframe;
}

bool KeyframeBuffers::has_next() const {
  return playout_ > 0;
}

bool KeyframeBuffers::finished() const {
  return ended_ && keyframes_.empty();
}

void KeyframeBuffers::fill_playout() {
  playout_ += std::min(options_.playout_capacity - playout_, receiver_fill());
}

void KeyframeBuffers::pop_front() {
  remove_first();
  if (playout_ > 0) --playout_;
}

void KeyframeBuffers::append(const Keyframe& keyframe) {
  keyframes_.push_back(keyframe);
  count(keyframe, 1);
}

void KeyframeBuffers::remove_first() {
  count(keyframes_.front(), -1);
  keyframes_.pop_front();
}

void KeyframeBuffers::count(const Keyframe& keyframe, int by) {
  if (keyframe.time) {
    timed_ += *keyframe.time * by;
  } else {
    untimed_count_ += by;
  }
}

}  // namespace aucast::playback
