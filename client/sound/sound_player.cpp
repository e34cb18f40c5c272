#include "client/sound/sound_player.h"

#include <algorithm>
#include <utility>

namespace aucast::sound {
namespace {

/// How many samples are still written when sound stops, so that it fades out.
constexpr std::int64_t kPortion = std::int64_t{10} * kSamplesPerMs;

}  // namespace

SoundPlayer::SoundPlayer(std::unique_ptr<SoundOut> out) {
  set_out(std::move(out));
}

void SoundPlayer::set_out(std::unique_ptr<SoundOut> out) {
  if (sounds_) stop();
  if (out_ != nullptr) underruns_ += out_->underruns();
  out_ = out == nullptr ? nullptr : std::make_unique<HeardOut>(std::move(out));
}

void SoundPlayer::open(playback::Playback* playback, SoundTrack* track) {
  if (sounds_) stop();
  before_ = counts();
  playback_ = playback;
  given_ = track;
  voice_ = std::make_unique<VoiceTrack>();
  mixer_ = std::make_unique<SoundMixer>(given_ != nullptr ? *given_ : *voice_);
  mixer_->set_volume(volume_);
  mixer_->set_muted(muted_);
}

/// Sound starts from the time that playback has come to.
void SoundPlayer::start(Instant steady) {
  sounds_ = true;
  begin_ = now_ - time_of(out_->written());
  sound_until_ = now_;
  out_->begin(steady);
}

/// The clock goes on from where it is, without sound.
void SoundPlayer::stop() {
  sounds_ = false;
  ahead_.reset();
  samples_.resize(static_cast<std::size_t>(kPortion));
  mixer_->mix(std::nullopt, samples_);
  write();
}

void SoundPlayer::write() {
  const Instant begin = begin_ + time_of(out_->written());
  if (tap_) tap_(*steady_ + (begin - shown_), samples_);
  out_->write(samples_);
}

Instant SoundPlayer::now(Instant steady) {
  if (!steady_) steady_ = now_ = shown_ = steady;
  const bool plays = playback_ != nullptr && (!playback_->over() || rings_on());
  if (sounds_ && !plays) stop();
  const bool wanted = plays && (given_ != nullptr || playback_->status().voice);
  if (!sounds_ && has_out() && wanted) start(steady);
  if (sounds_ && !out_->look(steady)) {
    stop();
    out_->close();
    lost_ = true;
  }
  steady_ = steady;
  if (sounds_) {
    const Instant heard = begin_ + out_->heard(steady);
    shown_ = std::max(shown_, heard);
    now_ = std::max(now_, heard + out_->lead());
  } else {
    if (!ahead_) ahead_ = now_ - steady;
    now_ = std::max(now_, steady + *ahead_);
    shown_ = now_;
  }
  if (playback_ != nullptr) playback_->set_clock(now_ - steady, now_ - shown_);
  return now_;
}

void SoundPlayer::advanced() {
  if (playback_ == nullptr) return;
  while (auto voice = playback_->take_voice()) voice_->add(voice->place, std::move(voice->opus));
  const auto passing = playback_->passing();
  if (!sounds_ && passing) voice_->skip(samples_of(passing->place));
  const bool ended = playback_->state() == playback::PlaybackState::Ended;
  if (ended && passing) voice_->end_at(samples_of(passing->place));
  if (!sounds_) return;
  const std::int64_t due = samples_of(now_ - begin_) - out_->written();
  if (due <= 0) return;
  const SoundTrack& track = given_ != nullptr ? *given_ : *voice_;
  if (passing && passing->speed > 0 && samples_of(passing->place) < track.end()) {
    sound_until_ = now_;
  }
  samples_.resize(static_cast<std::size_t>(due));
  mixer_->mix(passing, samples_);
  write();
}

void SoundPlayer::face_shown() {
  const auto heard = sounds_ ? out_->reported() : std::nullopt;
  const auto passing = heard ? playback_->passing() : std::nullopt;
  if (passing && passing->speed != 0) shifts_.add(shown_ - (begin_ + *heard));
}

bool SoundPlayer::take_loss() {
  return std::exchange(lost_, false);
}

void SoundPlayer::set_volume(int percent) {
  volume_ = percent;
  if (mixer_) mixer_->set_volume(percent);
}

void SoundPlayer::set_muted(bool muted) {
  muted_ = muted;
  if (mixer_) mixer_->set_muted(muted);
}

SoundCounts SoundPlayer::counts() const {
  SoundCounts counts = before_;
  if (voice_) counts.voice += voice_->counts();
  counts.underruns = underruns_ + (out_ == nullptr ? 0 : out_->underruns());
  counts.drift_ppm = out_ == nullptr ? std::nullopt : out_->drift_ppm();
  counts.shift = shifts_.summary();
  return counts;
}

}  // namespace aucast::sound
