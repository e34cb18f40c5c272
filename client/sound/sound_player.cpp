#include "client/sound/sound_player.h"

#include <algorithm>
#include <utility>

namespace aucast::sound {
namespace {

/// How many samples are still written when sound stops, so that it fades out.
constexpr std::int64_t kPortion = std::int64_t{10} * kSamplesPerMs;

Duration time_of(std::int64_t samples) {
  return std::chrono::microseconds(samples / kSamplesPerMs * 1000) +
         std::chrono::nanoseconds(samples % kSamplesPerMs * 1'000'000 / kSamplesPerMs);
}

std::int64_t samples_of(Duration time) {
  return time / std::chrono::milliseconds(1) * kSamplesPerMs +
         time % std::chrono::milliseconds(1) * kSamplesPerMs / std::chrono::milliseconds(1);
}

}  // namespace

SoundPlayer::SoundPlayer(std::unique_ptr<SoundOut> out) : out_(std::move(out)) {}

Instant SoundPlayer::moment_of(std::int64_t sample) const {
  return begin_ + time_of(sample);
}

void SoundPlayer::set_out(std::unique_ptr<SoundOut> out) {
  if (sounds_) stop();
  out_ = std::move(out);
  line_ = {};
  written_ = 0;
  heard_ = 0;
  lead_ = kLeadMin;
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
  begin_ = now_ - time_of(written_);
  sound_until_ = now_;
  heard_at_ = steady;
  starved_ = written_ > 0;
  line_.begin_again();
}

/// The clock goes on from where it is, without sound.
void SoundPlayer::stop() {
  sounds_ = false;
  ahead_.reset();
  if (out_ == nullptr) return;
  samples_.resize(static_cast<std::size_t>(kPortion));
  mixer_->mix(std::nullopt, samples_);
  write();
}

void SoundPlayer::write() {
  if (tap_) tap_(*steady_ + (moment_of(written_) - shown_), samples_);
  out_->write(samples_);
  written_ += static_cast<std::int64_t>(samples_.size());
}

Instant SoundPlayer::now(Instant steady) {
  if (!steady_) steady_ = now_ = shown_ = steady;
  const bool plays = playback_ != nullptr && (!playback_->over() || rings_on());
  if (sounds_ && !plays) stop();
  const bool wanted = plays && (given_ != nullptr || playback_->status().voice);
  if (!sounds_ && out_ != nullptr && wanted) start(steady);
  if (sounds_) look_at_device(steady);
  steady_ = steady;
  if (sounds_) {
    // What has run dry has been heard to its end; the line stands where it was looked at last.
    const Instant heard = starved_ ? moment_of(heard_) : begin_ + line_.at(steady);
    shown_ = std::max(shown_, heard);
    now_ = std::max(now_, heard + lead_);
  } else {
    if (!ahead_) ahead_ = now_ - steady;
    now_ = std::max(now_, steady + *ahead_);
    shown_ = now_;
  }
  if (playback_ != nullptr) playback_->set_clock(now_ - steady, now_ - shown_);
  return now_;
}

void SoundPlayer::look_at_device(Instant steady) {
  const std::int64_t heard = std::clamp(out_->heard(), heard_, written_);
  if (std::exchange(heard_, heard) != heard) heard_at_ = steady;
  line_.add(steady, time_of(heard));
  if (out_->lost() || steady - *heard_at_ > kDeafMax) {
    stop();
    out_.reset();
    lost_ = true;
  } else if (heard_ == written_ && !starved_ && written_ > 0) {
    starved_ = true;
    ++underruns_;
    lead_ = std::min<Duration>(lead_ + kLeadStep, kLeadMax);
    line_.begin_again();
  }
}

void SoundPlayer::feed() {
  while (auto voice = playback_->take_voice()) voice_->add(voice->place, std::move(voice->opus));
}

void SoundPlayer::advanced() {
  if (playback_ == nullptr) return;
  feed();
  const auto passing = playback_->passing();
  if (!sounds_ && passing) voice_->skip(samples_of(passing->place));
  const bool ended = playback_->state() == playback::PlaybackState::Ended;
  if (ended && passing) voice_->end_at(samples_of(passing->place));
  if (!sounds_) return;
  const std::int64_t due = samples_of(now_ - begin_) - written_;
  if (due <= 0) return;
  const SoundTrack& track = given_ != nullptr ? *given_ : *voice_;
  if (passing && passing->speed > 0 && samples_of(passing->place) < track.end()) {
    sound_until_ = now_;
  }
  samples_.resize(static_cast<std::size_t>(due));
  mixer_->mix(passing, samples_);
  write();
  starved_ = false;
}

void SoundPlayer::face_shown() {
  if (!sounds_ || playback_ == nullptr || heard_ == 0 || starved_) return;
  const auto passing = playback_->passing();
  if (!passing || passing->speed == 0) return;
  shifts_.add(shown_ - moment_of(std::clamp(out_->heard(), heard_, written_)));
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
  counts.underruns = underruns_;
  counts.drift_ppm = line_.drift_ppm();
  counts.shift = shifts_.summary();
  return counts;
}

}  // namespace aucast::sound
