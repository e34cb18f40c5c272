#include "client/sound/wav_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "client/sound/sound_track.h"
#include "common/files.h"
#include "common/text.h"
#include "common/voice/wav_bytes.h"

namespace aucast::sound {

WavFile::WavFile(std::filesystem::path path, TemporaryFile temporary, std::size_t samples_max)
    : path_(std::move(path)),
      temporary_(std::move(temporary)),
      file_(temporary_.path(), std::ios::binary | std::ios::trunc),
      samples_max_(samples_max) {
  file_ << voice::wav_head(0, kRate);
}

Result<std::unique_ptr<WavFile>> WavFile::open(const std::filesystem::path& path,
                                               std::size_t samples_max) {
  auto temporary = TemporaryFile::beside(path);
  if (!temporary) return temporary.error();
  return std::unique_ptr<WavFile>(new WavFile(path, std::move(*temporary), samples_max));
}

void WavFile::add(std::span<const float> samples) {
  const std::size_t room = samples_max_ - samples_;
  dropped_ = dropped_ || samples.size() > room;
  samples = samples.first(std::min(samples.size(), room));
  std::string bytes;
  bytes.reserve(samples.size() * 2);
  for (const float sample : samples) {
    voice::append_wav_sample(std::lround(std::clamp(sample, -1.0F, 1.0F) * 32767), bytes);
  }
  file_ << bytes;
  samples_ += samples.size();
}

std::string WavFile::complaint() const {
  if (!dropped_) return {};
  return at_place(path_.string(), "a WAV file holds " + std::to_string(kHours) +
                                      " hours of sound at most: what comes after is left out");
}

Result<void> WavFile::flush() {
  file_.seekp(0);
  file_ << voice::wav_head(samples_, kRate);
  file_.seekp(0, std::ios::end);
  file_.flush();
  if (file_) return {};
  return Error{ErrorKind::Failed, at_place(path_.string(), "cannot be written; is the disk full?")};
}

Result<void> WavFile::finish() {
  if (auto flushed = flush(); !flushed) return flushed;
  file_.close();
  return temporary_.replace(path_);
}

}  // namespace aucast::sound
