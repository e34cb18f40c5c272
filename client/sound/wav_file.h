#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>

#include "common/result.h"
#include "common/temporary_file.h"

namespace aucast::sound {

/// A WAV file: mono, 16 bits, kRate samples a second. It appears under its name when finish()
/// succeeds; a file that was there before stays until then. The same samples give the same bytes.
/// Thread: none of its own.
class WavFile {
 public:
  /// The most samples, some kHours, because a WAV file's sizes have 32 bits. Further samples are
  /// dropped, which is a complaint().
  static constexpr std::size_t kSamplesMax = std::size_t{0x7fff'0000};
  static constexpr int kHours = 12;

  /// Fails if the file cannot be written there. `samples_max`: at most kSamplesMax.
  [[nodiscard]] static Result<std::unique_ptr<WavFile>> open(const std::filesystem::path& path,
                                                             std::size_t samples_max = kSamplesMax);
  WavFile(const WavFile&) = delete;
  WavFile& operator=(const WavFile&) = delete;

  /// Adds samples, clamped to [-1,1].
  void add(std::span<const float> samples);
  /// How many samples have been added.
  [[nodiscard]] std::size_t samples() const { return samples_; }
  /// Whether further samples are dropped.
  [[nodiscard]] bool full() const { return samples_ == samples_max_; }
  /// Says that samples were dropped; empty: none were.
  [[nodiscard]] std::string complaint() const;
  /// Writes all samples so far to the file, which has the name temporary() until finish().
  [[nodiscard]] Result<void> flush();
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_.path(); }
  [[nodiscard]] Result<void> finish();

 private:
  WavFile(std::filesystem::path path, TemporaryFile temporary, std::size_t samples_max);

  std::filesystem::path path_;
  TemporaryFile temporary_;
  std::ofstream file_;
  std::size_t samples_max_;
  std::size_t samples_ = 0;
  bool dropped_ = false;  ///< samples for which there was no room
};

}  // namespace aucast::sound
