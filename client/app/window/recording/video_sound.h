#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "client/sound/wav_file.h"
#include "common/result.h"
#include "common/time.h"

namespace aucast::app {

/// The sound of a video of what happens, in step with its pictures: sound is handed over a little
/// before it is heard, in pieces and with pauses, and goes to where it was heard.
class VideoSound {
 public:
  /// Readings of a device's clock leap by less than this: what follows so closely goes on.
  static constexpr Milliseconds kSlack{40};

  /// The video begins at `begin` and is written to `video`; the sound goes to a file beside it for
  /// as long as this lives.
  [[nodiscard]] static Result<std::unique_ptr<VideoSound>> open(const std::filesystem::path& video,
                                                                Instant begin);

  /// The first of `samples` is heard at `heard_at`.
  void add(Instant heard_at, std::span<const float> samples);
  /// The WAV file with all of it; empty: nothing has sounded.
  [[nodiscard]] Result<std::filesystem::path> file();

 private:
  VideoSound(std::unique_ptr<sound::WavFile> wav, Instant begin)
      : wav_(std::move(wav)), begin_(begin) {}

  std::unique_ptr<sound::WavFile> wav_;
  Instant begin_;
};

}  // namespace aucast::app
