#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "client/sound/wav_file.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// The sound of a SessionVideo, in step with its pictures. Sound is handed over a little before it
/// is heard, in pieces and with pauses; each piece is put at the time at which it is heard.
class VideoSound {
 public:
  /// The readings of a device's clock are off by less than this. A piece that seems to be off by
  /// less therefore follows the previous one directly.
  static constexpr Milliseconds kSlack{40};

  /// The video begins at `begin` and is written to `video`. The sound is in a file beside it as
  /// long as this object lives.
  [[nodiscard]] static Result<std::unique_ptr<VideoSound>> open(
      const std::filesystem::path& video, Instant begin,
      std::size_t samples_max = sound::WavFile::kSamplesMax);

  /// Adds samples, the first of which is heard at `heard_at`.
  void add(Instant heard_at, std::span<const float> samples);
  /// Whether sound was left out because there was no room for it.
  [[nodiscard]] bool cut() const { return !wav_->complaint().empty(); }
  /// The WAV file with all of the sound; empty: there was no sound.
  [[nodiscard]] Result<std::filesystem::path> file();

 private:
  VideoSound(std::unique_ptr<sound::WavFile> wav, Instant begin)
      : wav_(std::move(wav)), begin_(begin) {}

  std::unique_ptr<sound::WavFile> wav_;
  Instant begin_;
};

}  // namespace aucast::app
