#include "client/sound/file_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <system_error>

#include "common/sound_name.h"
#include "common/voice/sound_file.h"
#include "common/voice/voice_encoder.h"

namespace aucast::sound {
namespace {

/// How many samples of ours there are to one of the file.
constexpr int kPhases = kRate / voice::kEncoderRate;
constexpr int kReach = 12;
constexpr int kTaps = 2 * kReach;
using Filter = std::array<std::array<float, kTaps>, kPhases>;

/// A filter for values between two samples of the file: a sinc with a Hann window, kReach samples
/// to each side. Phase 0 is the sample itself.
Filter make_filter() {
  Filter filter{};
  for (int phase = 0; phase < kPhases; ++phase) {
    for (int tap = 0; tap < kTaps; ++tap) {
      const double x = tap - (kReach - 1) - static_cast<double>(phase) / kPhases;
      const double sinc = x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
      const double window = 0.5 + 0.5 * std::cos(std::numbers::pi * x / kReach);
      filter[static_cast<std::size_t>(phase)][static_cast<std::size_t>(tap)] =
          static_cast<float>(sinc * window);
    }
  }
  return filter;
}

constexpr float kWhole = 32767;

}  // namespace

Result<std::unique_ptr<FileTrack>> FileTrack::open(const std::filesystem::path& path) {
  auto file = voice::SoundFile::open(path);
  if (!file) return file.error();
  std::unique_ptr<FileTrack> track(new FileTrack);
  std::vector<float> portion(voice::kEncoderRate);
  std::size_t count = portion.size();
  while (count == portion.size()) {
    count = file->read(portion);
    for (std::size_t i = 0; i < count; ++i) {
      const float sample = std::clamp(portion[i], -1.0F, 1.0F);
      track->samples_.push_back(static_cast<std::int16_t>(std::lround(sample * kWhole)));
    }
  }
  track->complaint_ = file->complaint();
  return track;
}

FileTrack::FileTrack(const std::vector<float>& samples) {
  for (const float sample : samples) {
    samples_.push_back(static_cast<std::int16_t>(std::lround(sample * kWhole)));
  }
}

void FileTrack::read(std::int64_t begin, std::span<float> samples) {
  static const Filter filter = make_filter();
  for (float& out : samples) {
    const std::int64_t at = begin++;
    const std::int64_t whole = at >= 0 ? at / kPhases : -((-at + kPhases - 1) / kPhases);
    const auto phase = static_cast<std::size_t>(at - whole * kPhases);
    float sum = 0;
    for (std::size_t tap = 0; tap < kTaps; ++tap) {
      sum += filter[phase][tap] * this->at(whole - (kReach - 1) + static_cast<std::int64_t>(tap));
    }
    out = sum / kWhole;
  }
}

float FileTrack::at(std::int64_t sample) const {
  const bool there = sample >= 0 && sample < static_cast<std::int64_t>(samples_.size());
  return there ? samples_[static_cast<std::size_t>(sample)] : 0;
}

std::int64_t FileTrack::end() const {
  return static_cast<std::int64_t>(samples_.size()) * kPhases;
}

std::optional<std::filesystem::path> sound_beside(const std::filesystem::path& stream_file) {
  for (const std::string_view ending : kSoundEndings) {
    std::filesystem::path sound = stream_file;
    sound.replace_extension(ending);
    std::error_code ignored;
    if (sound != stream_file && std::filesystem::exists(sound, ignored)) return sound;
  }
  return std::nullopt;
}

}  // namespace aucast::sound
