#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/sound/sound_track.h"
#include "common/result.h"

namespace aucast::sound {

/// A sound file as the track of a stream that is available whole. All of it is in memory: 115 MB
/// for an hour. Thread: none of its own.
class FileTrack final : public SoundTrack {
 public:
  /// Fails with Unreadable or BadData, as voice::SoundFile does.
  [[nodiscard]] static Result<std::unique_ptr<FileTrack>> open(const std::filesystem::path& path);
  /// Samples at voice::kEncoderRate, in [-1,1].
  explicit FileTrack(const std::vector<float>& samples);

  /// As voice::SoundFile::complaint().
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

  void read(std::int64_t begin, std::span<float> samples) override;
  [[nodiscard]] std::int64_t end() const override;

 private:
  FileTrack() = default;
  [[nodiscard]] float at(std::int64_t sample) const;

  std::vector<std::int16_t> samples_;
  std::string complaint_;
};

/// The sound file of the same name beside a stream file: .wav, .flac, .opus, .ogg or .mp3, the
/// first of them that exists; nullopt: none does.
[[nodiscard]] std::optional<std::filesystem::path> sound_beside(
    const std::filesystem::path& stream_file);

}  // namespace aucast::sound
