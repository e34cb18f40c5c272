#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "common/descriptor.h"
#include "common/result.h"

namespace aucast::voice {

/// The samples of a sound file at its own rate, its channels averaged.
class SoundReader {
 public:
  SoundReader() = default;
  SoundReader(const SoundReader&) = delete;
  SoundReader& operator=(const SoundReader&) = delete;
  virtual ~SoundReader() = default;

  /// Samples a second.
  [[nodiscard]] virtual int rate() const = 0;
  /// How many samples the file says it has.
  [[nodiscard]] virtual std::int64_t count() const = 0;
  /// Reads the next samples, in [-1,1], and returns how many; fewer than asked for only at the end.
  [[nodiscard]] virtual std::size_t read(std::span<float> samples) = 0;
  /// Why there is less sound than there should be, known after the last read(); empty: all is
  /// there.
  [[nodiscard]] virtual std::string complaint() const = 0;
  /// Whether the complaint is an error that the decoder met. Otherwise all that is in the file was
  /// decoded.
  [[nodiscard]] virtual bool damaged() const = 0;
};

/// Whether the file is what open_mp3() reads.
[[nodiscard]] bool is_mp3(int descriptor);

/// Opens an MP3 with libmpg123 directly. libsndfile reads MP3 by libmpg123 too, but lets that
/// library write to standard error. The message of an error is the cause alone.
[[nodiscard]] Result<std::unique_ptr<SoundReader>> open_mp3(Descriptor file);

/// Opens all other kinds, with libsndfile. The message of an error is the cause alone.
[[nodiscard]] Result<std::unique_ptr<SoundReader>> open_sndfile(Descriptor file);

}  // namespace aucast::voice
