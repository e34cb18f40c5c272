#include "client/app/window/recording/video_sound.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "client/sound/sound_track.h"

namespace aucast::app {
namespace {

/// Samples of silence that are written at once.
constexpr std::int64_t kSilentPortion = sound::kRate;

}  // namespace

Result<std::unique_ptr<VideoSound>> VideoSound::open(const std::filesystem::path& video,
                                                     Instant begin, std::size_t samples_max) {
  auto wav = sound::WavFile::open(video, samples_max);
  if (!wav) return wav.error();
  return std::unique_ptr<VideoSound>(new VideoSound(std::move(*wav), begin));
}

void VideoSound::add(Instant heard_at, std::span<const float> samples) {
  if (wav_->full()) return wav_->add(samples);  // which only notes that they are left out
  constexpr std::int64_t kSlackSamples = kSlack.count() * sound::kSamplesPerMs;
  const auto written = static_cast<std::int64_t>(wav_->samples());
  std::int64_t missing = sound::samples_of(heard_at - begin_) - written;
  if (written > 0 && missing > -kSlackSamples && missing < kSlackSamples) missing = 0;
  const std::vector<float> silence(
      static_cast<std::size_t>(std::clamp<std::int64_t>(missing, 0, kSilentPortion)));
  for (std::int64_t left = missing; left > 0; left -= kSilentPortion) {
    wav_->add(std::span(silence).first(static_cast<std::size_t>(std::min(left, kSilentPortion))));
  }
  // Samples that were heard before the video began, or were added already.
  const auto past = static_cast<std::size_t>(std::max<std::int64_t>(-missing, 0));
  wav_->add(samples.subspan(std::min(past, samples.size())));
}

Result<std::filesystem::path> VideoSound::file() {
  if (wav_->samples() == 0) return std::filesystem::path();
  if (auto flushed = wav_->flush(); !flushed) return flushed.error();
  return wav_->temporary();
}

}  // namespace aucast::app
