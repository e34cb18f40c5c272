#include "client/playback/playback_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/check.h"

namespace aucast::playback {
namespace {

/// The next keyframe of the source, if there is one now. Sets `ended` if there will never be one
/// again.
std::optional<Keyframe> take_next(KeyframeSource& source, bool& ended) {
  ended = false;
  if (auto keyframe = source.take()) return keyframe;
  if (!source.ready()) return std::nullopt;
  // Between the two calls a keyframe or the end may have come, so ask once more.
  auto keyframe = source.take();
  ended = !keyframe.has_value();
  return keyframe;
}

/// How long a keyframe that begins at `begin` is played; `time` is its own time.
Duration time_taken(const Keyframe& keyframe, Milliseconds time, Instant begin) {
  const Duration whole = time;
  // A voice that is half a per cent faster or slower sounds the same; a face may be so by five.
  const int bend = keyframe.spoken ? 5 : 50;
  const Duration aim = keyframe.due ? *keyframe.due - begin : whole * keyframe.pace_percent / 100;
  return std::clamp(aim, whole * (1000 - bend) / 1000, whole * (1000 + bend) / 1000);
}

PlaybackState state_after(EndReason reason) {
  switch (reason) {
    case EndReason::EndOfStream:
      return PlaybackState::Ended;
    case EndReason::Stopped:
      return PlaybackState::Stopped;
    case EndReason::NotEnded:
    case EndReason::ConnectionLost:
    case EndReason::ProtocolError:
    case EndReason::Unreachable:
    case EndReason::Refused:
      break;
  }
  return PlaybackState::Lost;
}

}  // namespace

std::string_view name(PlaybackState state) {
  switch (state) {
    case PlaybackState::Buffering:
      return "buffering";
    case PlaybackState::Playing:
      return "playing";
    case PlaybackState::Stalled:
      return "stalled";
    case PlaybackState::Stale:
      return "stale";
    case PlaybackState::Paused:
      return "paused";
    case PlaybackState::Ended:
      return "ended";
    case PlaybackState::Stopped:
      return "stopped";
    case PlaybackState::Lost:
      return "lost";
  }
  return "unknown";
}

bool is_over(PlaybackState state) {
  return state == PlaybackState::Ended || state == PlaybackState::Stopped ||
         state == PlaybackState::Lost;
}

PlaybackController::PlaybackController(std::optional<Milliseconds> speed) : speed_(speed) {}

std::optional<KeyframeBegun> PlaybackController::advance(Instant now, KeyframeSource& source) {
  looked_before_ = std::exchange(looked_at_, now);
  if (state_ == PlaybackState::Lost) return ease_when_due(now);
  if (state_ == PlaybackState::Paused || over()) return std::nullopt;
  if (state_ == PlaybackState::Stalled || state_ == PlaybackState::Stale) {
    return advance_stalled(now, source);
  }
  if (state_ != PlaybackState::Playing) return begin_next(now, now, source);

  move_to(now);
  if (progress_.position < kPositionsPerKeyframe) return std::nullopt;
  finish_keyframe(now);
  return begin_next(last_position_at_, now, source);
}

std::optional<KeyframeBegun> PlaybackController::advance_stalled(Instant now,
                                                                 KeyframeSource& source) {
  count_stall(now);
  move_easing(now);
  const double cut_at = eased_ ? progress_.mu : 1;
  if (auto begun = begin_next(now, now, source)) {
    begun->cut_at = cut_at;
    return begun;
  }
  return ease_when_due(now);
}

/// While nothing comes: begins the easing when it is due.
std::optional<KeyframeBegun> PlaybackController::ease_when_due(Instant now) {
  move_easing(now);
  const bool begun = progress_.keyframe > 0;
  if (eased_ || !hold_ || !begun || now - stalled_since_ < *hold_) return std::nullopt;
  if (state_ == PlaybackState::Stalled) state_ = PlaybackState::Stale;
  eased_ = true;
  ease_begin_ = now;
  progress_.mu = 0;
  progress_.position = 0;
  return KeyframeBegun{{AuFrame{}, kEaseTime}, kEaseTime};
}

void PlaybackController::move_easing(Instant now) {
  if (!eased_) return;
  const Duration eased = std::min<Duration>(now - ease_begin_, kEaseTime);
  progress_.mu = static_cast<double>(eased.count()) /
                 static_cast<double>(std::chrono::duration_cast<Duration>(kEaseTime).count());
  progress_.position = static_cast<int>(progress_.mu * kPositionsPerKeyframe);
}

void PlaybackController::count_stall(Instant now) {
  const Duration least = due_ ? kStallMin : Milliseconds::zero();
  if (stall_counted_ || now - stalled_since_ < least) return;
  stall_counted_ = true;
  ++stalls_;
}

std::optional<KeyframeBegun> PlaybackController::begin_next(Instant begin, Instant now,
                                                            KeyframeSource& source) {
  bool ended = false;
  auto keyframe = take_next(source, ended);
  if (!keyframe) {
    const bool played = state_ == PlaybackState::Playing;
    if (played) stalled_since_ = now;
    if (ended) {
      state_ = state_after(source.status().end);
    } else if (played) {
      state_ = PlaybackState::Stalled;
      stall_counted_ = false;
      count_stall(now);
    }
    return std::nullopt;
  }

  time_ = keyframe->time ? *keyframe->time : speed_ ? *speed_ : source.status().keyframe_time;
  AUCAST_CHECK(time_ >= Milliseconds::zero());
  if (video_clock_) {
    keyframe->pace_percent = 100;
    keyframe->arrived.reset();
    keyframe->due.reset();
  }
  // To the clock of the times handed in.
  if (keyframe->arrived) *keyframe->arrived += ahead_ - lead_;
  if (keyframe->due) *keyframe->due += ahead_;
  if (state_ == PlaybackState::Stalled && keyframe->due && keyframe->arrived) {
    begin = std::clamp(*keyframe->arrived, looked_before_, now);
  }
  takes_ = time_taken(*keyframe, time_, begin);
  place_ = keyframe->place;
  span_ = keyframe->span;
  arrived_ = keyframe->arrived;
  due_ = keyframe->due;
  eased_ = false;
  state_ = PlaybackState::Playing;
  keyframe_begin_ = begin;
  ++progress_.keyframe;
  move_to(now);
  return KeyframeBegun{std::move(*keyframe), time_};
}

void PlaybackController::finish_keyframe(Instant now) {
  if (arrived_) delays_.add(now - *arrived_);
  if (arrived_ && due_) delays_meant_.add(*due_ - *arrived_);
  ++keyframes_played_;
  media_time_ += time_;
}

void PlaybackController::move_to(Instant now) {
  const Duration whole = takes_;
  const Duration elapsed = std::clamp(now - keyframe_begin_, Duration::zero(), whole);
  if (elapsed == whole) {
    progress_.position = kPositionsPerKeyframe;
    progress_.mu = 1;
  } else {
    progress_.position = static_cast<int>(elapsed * kPositionsPerKeyframe / whole);
    progress_.mu = static_cast<double>(elapsed.count()) / static_cast<double>(whole.count());
  }
  last_position_at_ = keyframe_begin_ + whole * progress_.position / kPositionsPerKeyframe;
}

PlaybackState PlaybackController::state() const {
  const bool waits = state_ == PlaybackState::Stalled && !stall_counted_;
  return waits ? PlaybackState::Playing : state_;
}

PlaybackProgress PlaybackController::progress() const {
  return progress_;
}

std::optional<Passing> PlaybackController::passing() const {
  if (!place_) return std::nullopt;
  const Duration reached = *place_;
  if (state_ == PlaybackState::Ended) {
    return Passing{reached + (looked_at_ - last_position_at_), 1};
  }
  const bool plays = state_ == PlaybackState::Playing;
  if ((!plays && !stood_at_) || takes_ == Duration::zero()) return Passing{reached, 0};
  const Duration own = span_;
  const Duration since = plays ? looked_at_ - keyframe_begin_
                               : std::clamp(*stood_at_ - keyframe_begin_, Duration::zero(), takes_);
  if (takes_ == own) return Passing{reached - own + since, plays ? 1.0 : 0.0};
  const double speed = static_cast<double>(own.count()) / static_cast<double>(takes_.count());
  const auto passed = Duration(std::llround(static_cast<double>(since.count()) * speed));
  return Passing{reached - own + passed, plays ? speed : 0};
}

std::optional<Instant> PlaybackController::next_position_at() const {
  const bool neutral_next = state_ == PlaybackState::Stale || state_ == PlaybackState::Lost;
  const bool eases = eased_ && neutral_next && progress_.mu < 1;
  if (state_ != PlaybackState::Playing && !eases) return std::nullopt;
  const Duration whole = eases ? Duration(kEaseTime) : takes_;
  const int next = std::min(progress_.position + 1, kPositionsPerKeyframe);
  return (eases ? ease_begin_ : keyframe_begin_) + whole * next / kPositionsPerKeyframe;
}

void PlaybackController::pause(Instant now) {
  if (state_ == PlaybackState::Paused || over()) return;
  stand(now);
  paused_from_ = state_;
  paused_since_ = now;
  state_ = PlaybackState::Paused;
}

/// Holds the keyframe under way, if there is one, where it is at `now`.
void PlaybackController::stand(Instant now) {
  if (state_ != PlaybackState::Playing) return;
  move_to(now);
  stood_at_ = now;
}

void PlaybackController::resume(Instant now) {
  if (state_ != PlaybackState::Paused) return;
  state_ = paused_from_;
  stood_at_.reset();
  // Shifting the begin by the pause keeps the fraction; what was reached before stays reached.
  keyframe_begin_ += now - paused_since_;
  stalled_since_ += now - paused_since_;
  ease_begin_ += now - paused_since_;
  looked_at_ = now;
}

void PlaybackController::stop(Instant now) {
  if (over()) return;
  stand(now);
  const PlaybackState at = state_ == PlaybackState::Paused ? paused_from_ : state_;
  if (at == PlaybackState::Playing && progress_.position == kPositionsPerKeyframe)
    finish_keyframe(now);
  state_ = PlaybackState::Stopped;
}

bool PlaybackController::over() const {
  return is_over(state_);
}

std::uint64_t PlaybackController::keyframes_played() const {
  return keyframes_played_;
}

std::uint64_t PlaybackController::stalls() const {
  return stalls_;
}

Milliseconds PlaybackController::media_time() const {
  return media_time_;
}

}  // namespace aucast::playback
