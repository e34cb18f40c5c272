#include "client/playback/seekable_playback.h"

#include <utility>

#include "client/playback/movement.h"

namespace aucast::playback {
namespace {

/// The time between positions: a hundred pictures a second, more than displays show.
constexpr Milliseconds kLookEvery{10};

std::vector<Milliseconds> times_of(const KeyframeList& keyframes, Milliseconds untimed) {
  std::vector<Milliseconds> times;
  times.reserve(keyframes.size());
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    times.push_back(keyframes.time(i).value_or(untimed));
  }
  return times;
}

}  // namespace

SeekablePlayback::SeekablePlayback(KeyframeList keyframes, Milliseconds untimed)
    : keyframes_(std::move(keyframes)),
      playhead_(times_of(keyframes_, untimed)),
      ends_(std::make_shared<const std::vector<Duration>>(playhead_.ends())),
      untimed_(untimed) {}

LocalPlayback& SeekablePlayback::playhead(Instant now) {
  if (std::exchange(untouched_, false)) playhead_.play(now);
  return playhead_;
}

std::optional<KeyframeBegun> SeekablePlayback::advance(Instant now) {
  looked_at_ = now;
  position_ = playhead(now).position(now);
  ended_ = playhead_.over(now);
  const StreamPlace before = std::exchange(place_, playhead_.place(position_));
  if (std::exchange(begun_, true) && before.keyframe == place_.keyframe) return std::nullopt;
  return under_way();
}

KeyframeBegun SeekablePlayback::under_way() const {
  const Keyframe target = keyframes_[place_.keyframe];
  KeyframeBegun begun{target, target.time.value_or(untimed_)};
  begun.from = place_.keyframe == 0 ? AuFrame{} : keyframes_.aus(place_.keyframe - 1);
  return begun;
}

void SeekablePlayback::pause(Instant now) {
  untouched_ = false;
  playhead_.pause(now);
}

void SeekablePlayback::resume(Instant now) {
  untouched_ = false;
  stopped_ = false;
  playhead_.play(now);
}

void SeekablePlayback::stop(Instant now) {
  looked_at_ = now;
  stopped_ = !ended_;
  pause(now);
}

PlaybackState SeekablePlayback::state() const {
  if (stopped_) return PlaybackState::Stopped;
  if (ended_) return PlaybackState::Ended;
  return playhead_.playing() ? PlaybackState::Playing : PlaybackState::Paused;
}

PlaybackProgress SeekablePlayback::progress() const {
  if (!begun_) return {};
  return {place_.keyframe + 1, static_cast<int>(place_.mu * kPositionsPerKeyframe), place_.mu};
}

std::optional<Instant> SeekablePlayback::next_position_at() const {
  if (state() != PlaybackState::Playing) return std::nullopt;
  return looked_at_ + kLookEvery;
}

std::optional<Passing> SeekablePlayback::passing() const {
  const bool moves = state() == PlaybackState::Playing;
  return Passing{position_, moves ? playhead_.speed_percent() / 100.0 : 0};
}

std::uint64_t SeekablePlayback::keyframes_played() const {
  return playhead_.keyframes_played(looked_at_);
}

Duration SeekablePlayback::media_time() const {
  return playhead_.media_time(looked_at_);
}

SourceStatus SeekablePlayback::status() const {
  SourceStatus status;
  status.local = true;
  status.end = stopped_ ? EndReason::Stopped : EndReason::EndOfStream;
  status.keyframes_received = keyframes_.size();
  return status;
}

}  // namespace aucast::playback
