#include "client/playback/source_playback.h"

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
  if (reason == EndReason::EndOfStream) return PlaybackState::Ended;
  return reason == EndReason::Stopped ? PlaybackState::Stopped : PlaybackState::Lost;
}

}  // namespace

SourcePlayback::SourcePlayback(std::unique_ptr<KeyframeSource> source, const Options& options)
    : source_(std::move(source)), options_(options) {
  AUCAST_CHECK(source_ != nullptr);
}

std::optional<KeyframeBegun> SourcePlayback::advance(Instant now) {
  if (paused_ || state_ == PlaybackState::Stopped) return std::nullopt;
  const Instant before = std::exchange(now_, now);
  switch (state_) {
    case PlaybackState::Buffering:
      return begin_next(now, now);
    case PlaybackState::Playing:
      move();
      if (progress_.position < kPositionsPerKeyframe) return std::nullopt;
      finish_keyframe();
      return begin_next(movement_.end(), movement_.end());
    case PlaybackState::Stalled:
    case PlaybackState::Stale: {
      count_stall();
      const Instant earliest = state_ == PlaybackState::Stalled ? before : now;
      if (auto begun = begin_next(earliest, now)) return begun;
      return hold_or_ease();
    }
    case PlaybackState::Lost:
      return hold_or_ease();
    case PlaybackState::Paused:
    case PlaybackState::Ended:
    case PlaybackState::Stopped:
      break;
  }
  return std::nullopt;
}

/// While nothing comes: begins the easing when it is due.
std::optional<KeyframeBegun> SourcePlayback::hold_or_ease() {
  if (wait_.easing) {
    move();
    return std::nullopt;
  }
  const bool begun = progress_.keyframe > 0;
  if (!options_.hold || !begun || now_ - wait_.since < *options_.hold) return std::nullopt;
  if (state_ == PlaybackState::Stalled) state_ = PlaybackState::Stale;
  wait_.easing = Movement{now_, kEaseTime};
  move();
  return KeyframeBegun{{AuFrame{}, kEaseTime}, kEaseTime};
}

void SourcePlayback::count_stall() {
  const Duration least = current_.target.due ? kStallMin : Milliseconds::zero();
  if (wait_.counted || now_ - wait_.since < least) return;
  wait_.counted = true;
  ++stalls_;
}

std::optional<KeyframeBegun> SourcePlayback::begin_next(Instant earliest, Instant latest) {
  bool ended = false;
  auto keyframe = take_next(*source_, ended);
  if (!keyframe) {
    wait_for_next(ended ? std::optional(source_->status().end) : std::nullopt);
    return std::nullopt;
  }

  const auto given = keyframe->time ? keyframe->time : options_.speed;
  const Milliseconds time = given ? *given : source_->status().keyframe_time;
  AUCAST_CHECK(time >= Milliseconds::zero());
  if (options_.video_clock) {
    keyframe->pace_percent = 100;
    keyframe->arrived.reset();
    keyframe->due.reset();
  }
  // To the clock of the times handed in.
  if (keyframe->arrived) *keyframe->arrived += ahead_ - lead_;
  if (keyframe->due) *keyframe->due += ahead_;
  const bool timed = keyframe->due && keyframe->arrived;
  const Instant begin = timed ? std::clamp(*keyframe->arrived, earliest, latest) : latest;
  const double cut_at = wait_.easing ? wait_.easing->mu(now_) : 1;
  movement_ = {begin, time_taken(*keyframe, time, begin)};
  current_ = {std::move(*keyframe), time, cut_at};
  wait_ = {};
  state_ = PlaybackState::Playing;
  ++progress_.keyframe;
  move();
  return current_;
}

/// Nothing has come; `end`: nothing ever will, for this reason.
void SourcePlayback::wait_for_next(std::optional<EndReason> end) {
  const bool played = state_ == PlaybackState::Playing;
  if (played) wait_.since = now_;
  if (end) {
    state_ = state_after(*end);
  } else if (played) {
    state_ = PlaybackState::Stalled;
    count_stall();
  }
}

void SourcePlayback::finish_keyframe() {
  const Keyframe& reached = current_.target;
  if (reached.arrived) delays_.add(now_ - *reached.arrived);
  if (reached.arrived && reached.due) delays_meant_.add(*reached.due - *reached.arrived);
  ++keyframes_played_;
  media_time_ += current_.time;
}

/// Moves the face to where it is at now_.
void SourcePlayback::move() {
  if (progress_.keyframe == 0) return;
  const Movement& movement = wait_.easing ? *wait_.easing : movement_;
  progress_.position = movement.position(now_);
  progress_.mu = movement.mu(now_);
}

PlaybackState SourcePlayback::state() const {
  if (paused_) return PlaybackState::Paused;
  const bool unseen = state_ == PlaybackState::Stalled && !wait_.counted;
  return unseen ? PlaybackState::Playing : state_;
}

std::optional<Passing> SourcePlayback::passing() const {
  if (!current_.target.place) return std::nullopt;
  const Duration reached = *current_.target.place;
  if (state_ == PlaybackState::Ended) return Passing{reached + (now_ - movement_.end()), 1};
  const Duration takes = movement_.takes;
  if (takes == Duration::zero()) return Passing{reached, 0};
  const bool plays = state_ == PlaybackState::Playing && !paused_;
  const Duration own = current_.target.span;
  const Duration since = movement_.passed(now_);
  const double speed = static_cast<double>(own.count()) / static_cast<double>(takes.count());
  const auto passed = Duration(std::llround(static_cast<double>(since.count()) * speed));
  return Passing{reached - own + passed, plays ? speed : 0};
}

std::optional<Instant> SourcePlayback::next_position_at() const {
  if (paused_) return std::nullopt;
  const bool neutral_next = state_ == PlaybackState::Stale || state_ == PlaybackState::Lost;
  const bool eases = wait_.easing && neutral_next && progress_.mu < 1;
  if (state_ != PlaybackState::Playing && !eases) return std::nullopt;
  const int next = std::min(progress_.position + 1, kPositionsPerKeyframe);
  return (eases ? *wait_.easing : movement_).reaches(next);
}

void SourcePlayback::set_clock(Duration ahead, Duration lead) {
  ahead_ = ahead;
  lead_ = lead;
}

void SourcePlayback::pause(Instant now) {
  source_->pause();
  if (paused_ || over()) return;
  stand(now);
  paused_ = true;
}

/// Holds the face where it is at `now`.
void SourcePlayback::stand(Instant now) {
  now_ = now;
  move();
}

void SourcePlayback::resume(Instant now) {
  source_->resume();
  if (!paused_) return;
  paused_ = false;
  const Duration stood = now - std::exchange(now_, now);
  // What is under way begins that much later, which keeps its fraction; what was reached before
  // stays reached.
  if (state_ == PlaybackState::Playing) movement_.begin += stood;
  wait_.since += stood;
  if (wait_.easing) wait_.easing->begin += stood;
}

void SourcePlayback::stop(Instant now) {
  if (over()) return;
  source_->stop();
  if (!paused_) stand(now);
  paused_ = false;
  if (state_ == PlaybackState::Playing && progress_.position == kPositionsPerKeyframe) {
    finish_keyframe();
  }
  state_ = PlaybackState::Stopped;
}

}  // namespace aucast::playback
