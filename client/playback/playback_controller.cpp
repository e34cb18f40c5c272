#include "client/playback/playback_controller.h"

#include <algorithm>
#include <utility>

#include "common/check.h"

namespace aucast::playback {
namespace {

/// The next keyframe of the source. `ended` is set when there will never be one again.
std::optional<TimedAus> take_next(KeyframeSource& source, bool& ended) {
  ended = false;
  if (auto keyframe = source.take()) return keyframe;
  if (!source.ready()) return std::nullopt;
  // Between the two calls one may have come, or the end: now it is one or the other for good.
  auto keyframe = source.take();
  ended = !keyframe.has_value();
  return keyframe;
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

PlaybackController::PlaybackController(std::optional<Milliseconds> speed) : speed_(speed) {}

std::optional<KeyframeBegun> PlaybackController::advance(Instant now, KeyframeSource& source) {
  if (state_ == PlaybackState::Paused || over()) return std::nullopt;
  if (state_ == PlaybackState::Stalled || state_ == PlaybackState::Stale) {
    return advance_stalled(now, source);
  }
  if (state_ != PlaybackState::Playing) return begin_next(now, now, source);

  move_to(now);
  if (moment_.position < kPositionsPerKeyframe) return std::nullopt;
  finish_keyframe();
  return begin_next(last_position_at_, now, source);
}

std::optional<KeyframeBegun> PlaybackController::advance_stalled(Instant now,
                                                                 KeyframeSource& source) {
  if (state_ == PlaybackState::Stale) {
    const Duration eased = std::min<Duration>(now - ease_begin_, kEaseTime);
    moment_.mu = static_cast<double>(eased.count()) /
                 static_cast<double>(std::chrono::duration_cast<Duration>(kEaseTime).count());
    moment_.position = static_cast<int>(moment_.mu * kPositionsPerKeyframe);
  }
  const double cut_at = state_ == PlaybackState::Stale ? moment_.mu : 1;
  if (auto begun = begin_next(now, now, source)) {
    begun->cut_at = cut_at;
    return begun;
  }
  if (state_ != PlaybackState::Stalled || !hold_ || now - stalled_since_ < *hold_) {
    return std::nullopt;
  }
  state_ = PlaybackState::Stale;
  ease_begin_ = now;
  moment_.mu = 0;
  moment_.position = 0;
  return KeyframeBegun{{AuFrame{}, kEaseTime}, kEaseTime};
}

std::optional<KeyframeBegun> PlaybackController::begin_next(Instant begin, Instant now,
                                                            KeyframeSource& source) {
  bool ended = false;
  auto keyframe = take_next(source, ended);
  if (!keyframe) {
    if (ended) {
      state_ = state_after(source.status().end);
    } else if (state_ == PlaybackState::Playing) {
      state_ = PlaybackState::Stalled;
      stalled_since_ = now;
      ++stalls_;
    }
    return std::nullopt;
  }

  duration_ = keyframe->duration ? *keyframe->duration
              : speed_           ? *speed_
                                 : source.status().keyframe_time;
  AUCAST_CHECK(duration_ >= Milliseconds::zero());
  state_ = PlaybackState::Playing;
  keyframe_begin_ = begin;
  if (!first_begin_) first_begin_ = begin;
  ++moment_.keyframe;
  move_to(now);
  return KeyframeBegun{std::move(*keyframe), duration_};
}

void PlaybackController::finish_keyframe() {
  ++keyframes_played_;
  media_time_ += duration_;
}

void PlaybackController::move_to(Instant now) {
  const Duration whole = duration_;
  const Duration elapsed = std::clamp(now - keyframe_begin_, Duration::zero(), whole);
  if (elapsed == whole) {
    moment_.position = kPositionsPerKeyframe;
    moment_.mu = 1;
  } else {
    moment_.position = static_cast<int>(elapsed * kPositionsPerKeyframe / whole);
    moment_.mu = static_cast<double>(elapsed.count()) / static_cast<double>(whole.count());
  }
  last_position_at_ = keyframe_begin_ + whole * moment_.position / kPositionsPerKeyframe;
}

PlaybackState PlaybackController::state() const {
  return state_;
}

PlaybackMoment PlaybackController::moment() const {
  return moment_;
}

std::optional<Instant> PlaybackController::next_position_at() const {
  if (state_ != PlaybackState::Playing) return std::nullopt;
  const int next = std::min(moment_.position + 1, kPositionsPerKeyframe);
  return keyframe_begin_ + Duration(duration_) * next / kPositionsPerKeyframe;
}

void PlaybackController::pause(Instant now) {
  if (state_ == PlaybackState::Paused || over()) return;
  if (state_ == PlaybackState::Playing) move_to(now);
  paused_from_ = state_;
  paused_since_ = now;
  state_ = PlaybackState::Paused;
}

void PlaybackController::resume(Instant now) {
  if (state_ != PlaybackState::Paused) return;
  state_ = paused_from_;
  // Shifting the begin by the pause keeps the fraction; what was reached before stays reached.
  keyframe_begin_ += now - paused_since_;
  stalled_since_ += now - paused_since_;
  ease_begin_ += now - paused_since_;
}

void PlaybackController::stop(Instant now) {
  if (over()) return;
  if (state_ == PlaybackState::Playing) move_to(now);
  const PlaybackState at = state_ == PlaybackState::Paused ? paused_from_ : state_;
  if (at == PlaybackState::Playing && moment_.position == kPositionsPerKeyframe) finish_keyframe();
  state_ = PlaybackState::Stopped;
}

bool PlaybackController::over() const {
  return state_ == PlaybackState::Ended || state_ == PlaybackState::Stopped ||
         state_ == PlaybackState::Lost;
}

std::uint64_t PlaybackController::keyframes_played() const {
  return keyframes_played_;
}

std::uint64_t PlaybackController::stalls() const {
  return stalls_;
}

Duration PlaybackController::playback_time() const {
  return first_begin_ ? last_position_at_ - *first_begin_ : Duration::zero();
}

Milliseconds PlaybackController::media_time() const {
  return media_time_;
}

}  // namespace aucast::playback
