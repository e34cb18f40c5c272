#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "common/result.h"
#include "common/time.h"

namespace aucast::voice {

/// A recording of sound, read as the encoder wants it: mono at kEncoderRate, whatever the file's
/// own rate and channels are (channels are averaged). Reads WAV, FLAC, Ogg Vorbis, Ogg Opus and
/// MP3.
/// Thread: none of its own.
class SoundFile {
 public:
  /// Fails with Unreadable if the file is missing or is no regular file. Fails with BadData if the
  /// file has no sound, if its header gives a length of a day or more, or if its length is unknown:
  /// Ogg that does not end with a whole page, FLAC that was written to a pipe.
  [[nodiscard]] static Result<SoundFile> open(const std::filesystem::path& path);
  ~SoundFile();
  SoundFile(SoundFile&&) noexcept;
  SoundFile& operator=(SoundFile&&) noexcept;

  /// Reads the next samples, in [-1,1], and returns how many; fewer than asked for only at the end.
  [[nodiscard]] std::size_t read(std::span<float> samples);
  /// Returns a message that names the file and says how it was cut off or damaged; empty: the file
  /// seems to be whole. Call it when read() has come to the end. MP3 without a Xing header and WAV
  /// that was written to a pipe seem whole even if they were cut off.
  [[nodiscard]] std::string complaint() const;
  /// Whether the complaint is that the sound itself is damaged and could not be decoded further.
  /// Otherwise all that is in the file was decoded, but the file says that there was more.
  [[nodiscard]] bool damaged() const;
  /// The length that the file's header gives, less than a day.
  [[nodiscard]] Milliseconds duration() const;

 private:
  struct State;
  explicit SoundFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::voice
