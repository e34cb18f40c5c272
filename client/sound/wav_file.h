#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>

#include "common/result.h"
#include "common/temporary_file.h"

namespace aucast::sound {

/// A WAV file: mono, 16 bits, kRate samples a second. It appears under its name when finish()
/// succeeds; a file that was there before stays until then. The same samples give the same bytes.
/// Thread: none of its own.
class WavFile {
 public:
  /// The most samples, some 12 hours, because a WAV file's sizes have 32 bits. Further samples are
  /// dropped.
  static constexpr std::size_t kSamplesMax = std::size_t{0x7fff'0000};

  /// Fails if the file cannot be written there.
  [[nodiscard]] static Result<std::unique_ptr<WavFile>> open(const std::filesystem::path& path);
  WavFile(const WavFile&) = delete;
  WavFile& operator=(const WavFile&) = delete;

  /// Adds samples, clamped to [-1,1].
  void add(std::span<const float> samples);
  /// How many samples have been added.
  [[nodiscard]] std::size_t samples() const { return samples_; }
  /// Writes all samples so far to the file, which has the name temporary() until finish().
  [[nodiscard]] Result<void> flush();
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_.path(); }
  [[nodiscard]] Result<void> finish();

 private:
  WavFile(std::filesystem::path path, TemporaryFile temporary);

  std::filesystem::path path_;
  TemporaryFile temporary_;
  std::ofstream file_;
  std::size_t samples_ = 0;
};

}  // namespace aucast::sound
