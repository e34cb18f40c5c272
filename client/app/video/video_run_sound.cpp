#include "client/app/video/video_run_sound.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aucast::app {
namespace {

/// Samples that are written at once.
constexpr std::int64_t kPortion = sound::kRate;

}  // namespace

VideoRunSound::VideoRunSound(playback::Playback& playback, sound::SoundTrack* track,
                             const std::function<bool()>& stop)
    : playback_(playback),
      track_(track != nullptr ? *track : voice_),
      stop_(stop),
      mixer_(track_) {}

Result<void> VideoRunSound::open(const SoundOptions& sound, const OutputOptions& output) {
  if (!wants_video_sound(sound, output)) return {};
  keep_ = !sound.file.empty();
  auto wav = sound::WavFile::open(keep_ ? sound.file : output.record);
  if (!wav) return wav.error();
  wav_ = std::move(*wav);
  mixer_.set_volume(sound.volume);
  mixer_.set_muted(sound.mute);
  return {};
}

void VideoRunSound::take_in() {
  while (auto voice = playback_.take_voice()) voice_.add(voice->place, std::move(voice->opus));
}

void VideoRunSound::keyframe(const playback::KeyframeBegun& begun, std::int64_t end_ms) {
  take_in();
  if (!begun.target.place) return write(std::nullopt, end_ms);
  place_ms_ = begun.target.place->count();
  const double time = seconds(begun.time);
  const double speed = begun.target.span == begun.time ? 1
                       : time > 0                      ? seconds(begun.target.span) / time
                                                       : 0;
  write(playback::Passing{*begun.target.place, speed}, end_ms);
}

std::int64_t VideoRunSound::tail_ms() {
  if (wav_ == nullptr) return 0;
  take_in();
  voice_.end_at(place_ms_ * sound::kSamplesPerMs);
  const std::int64_t end_ms = (track_.end() + sound::kSamplesPerMs - 1) / sound::kSamplesPerMs;
  return std::max<std::int64_t>(end_ms - place_ms_, 0);
}

void VideoRunSound::tail(std::int64_t end_ms) {
  place_ms_ += tail_ms();
  write(playback::Passing{Milliseconds(place_ms_), 1}, end_ms);
}

/// If the run has no sound at all, no silence is written for its videos.
void VideoRunSound::write(std::optional<playback::Passing> at_end, std::int64_t end_ms) {
  const std::int64_t begin_ms = std::exchange(end_ms_, end_ms);
  if (wav_ == nullptr || (!keep_ && track_.end() == 0)) return;
  mix(std::nullopt, begin_ms);
  mix(at_end, end_ms);
}

void VideoRunSound::mix(std::optional<playback::Passing> at_end, std::int64_t end_ms) {
  const std::int64_t due = end_ms * sound::kSamplesPerMs;
  while (written_ < due && !stop_()) {
    const std::int64_t count = std::min(due - written_, kPortion);
    auto passing = at_end;
    if (passing) {
      const double left = static_cast<double>(due - written_ - count) / sound::kRate;
      passing->place -= Duration(std::llround(left * passing->speed * 1e9));
    }
    samples_.resize(static_cast<std::size_t>(count));
    mixer_.mix(passing, samples_);
    wav_->add(samples_);
    written_ += count;
  }
}

Result<std::filesystem::path> VideoRunSound::file() {
  if (wav_ == nullptr || track_.end() == 0) return std::filesystem::path();
  if (auto flushed = wav_->flush(); !flushed) return flushed.error();
  return wav_->temporary();
}

Result<void> VideoRunSound::finish() {
  return keep_ ? wav_->finish() : Result<void>();
}

}  // namespace aucast::app
