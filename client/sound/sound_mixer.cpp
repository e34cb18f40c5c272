#include "client/sound/sound_mixer.h"

#include <algorithm>
#include <cmath>

namespace aucast::sound {
namespace {

constexpr int kStepGlide = 5 * kSamplesPerMs;
/// How far the gain may change from one sample to the next: 10 ms from silence to full volume.
constexpr float kGainStep = 1.0F / (10 * kSamplesPerMs);
/// The distance from where it should be, in samples, up to which the sound goes on without a skip:
/// a thousandth of a second when it is resampled anyway, else what rounding the clock can amount
/// to.
constexpr double kOffResampled = kSamplesPerMs;
constexpr double kOffCopied = 1.5;
const float kFallPerSample = std::pow(0.05F, 1.0F / static_cast<float>(kRate));

/// Catmull-Rom through four samples, between the second and the third.
float between(const float* taps, float t) {
  const float a = taps[3] - 3 * taps[2] + 3 * taps[1] - taps[0];
  const float b = 2 * taps[0] - 5 * taps[1] + 4 * taps[2] - taps[3];
  return taps[1] + 0.5F * t * (taps[2] - taps[0] + t * (b + t * a));
}

}  // namespace

void SoundMixer::mix(std::optional<playback::Passing> at_end, std::span<float> samples) {
  if (samples.empty()) return;
  const bool sounds = at_end && at_end->speed >= kSpeedMin && at_end->speed <= kSpeedMax;
  if (!sounds) {
    const bool broken = next_.has_value();
    next_.reset();
    std::fill(samples.begin(), samples.end(), 0.0F);
    glide(broken, samples);
  } else {
    const double to = aucast::seconds(at_end->place) * kRate;
    const bool copies = at_end->speed == 1;
    const double from = to - static_cast<double>(samples.size()) * at_end->speed;
    const double off_max = copies ? kOffCopied : kOffResampled;
    const bool broken = !next_ || std::abs(*next_ - from) > off_max;
    if (broken) next_ = from;
    if (copies) {
      next_ = std::round(*next_);
      copy(samples);
    } else {
      resample(to, samples);
    }
    glide(broken, samples);
  }
  measure(samples);
  scale(samples);
}

void SoundMixer::copy(std::span<float> samples) {
  track_.read(static_cast<std::int64_t>(*next_), samples);
  *next_ += static_cast<double>(samples.size());
}

void SoundMixer::resample(double to, std::span<float> samples) {
  const double from = *next_;
  // A place that lies a little back is waited for.
  const double step = std::max(0.0, (to - from) / static_cast<double>(samples.size()));
  const auto first = static_cast<std::int64_t>(std::floor(from)) - 1;
  // No sample from `to` on is asked for: its packet may still be on its way.
  const auto behind = static_cast<std::int64_t>(std::ceil(to));
  taps_.resize(static_cast<std::size_t>(std::max<std::int64_t>(behind - first, 1)));
  track_.read(first, taps_);
  taps_.resize(taps_.size() + 4, taps_.back());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double at = from + step * static_cast<double>(i);
    const double whole = std::floor(at);
    const auto tap = static_cast<std::size_t>(static_cast<std::int64_t>(whole) - 1 - first);
    samples[i] = between(&taps_[tap], static_cast<float>(at - whole));
  }
  next_ = std::max(to, from);
}

void SoundMixer::glide(bool broken, std::span<float> samples) {
  if (broken) {
    step_ = last_ - samples.front();
    step_left_ = kStepGlide;
  }
  for (float& sample : samples) {
    if (step_left_ == 0) break;
    sample += step_ * static_cast<float>(step_left_) / kStepGlide;
    --step_left_;
  }
  last_ = samples.back();
}

void SoundMixer::measure(std::span<const float> samples) {
  float peak = peak_;
  for (const float sample : samples) {
    peak = std::max(peak * kFallPerSample, std::min(std::abs(sample), 1.0F));
  }
  peak_ = peak < 1e-6F ? 0 : peak;
}

void SoundMixer::scale(std::span<float> samples) {
  const float aim = muted_ ? 0 : volume_;
  for (float& sample : samples) {
    if (gain_ != aim) gain_ += std::clamp(aim - gain_, -kGainStep, kGainStep);
    sample *= gain_;
  }
}

void SoundMixer::set_volume(int percent) {
  const float part = static_cast<float>(std::clamp(percent, 0, 100)) / 100;
  volume_ = part * part * part;
}

}  // namespace aucast::sound
