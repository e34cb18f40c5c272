#include "client/sound/wav_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>

#include "client/sound/sound_track.h"
#include "common/files.h"
#include "common/text.h"

namespace aucast::sound {
namespace {

constexpr std::size_t kBytesPerSample = 2;

void put(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xffU));
}

std::string header(std::size_t samples) {
  const auto size = static_cast<std::uint32_t>(samples * kBytesPerSample);
  std::string bytes = "RIFF";
  put(bytes, 36 + size, 4);
  bytes += "WAVEfmt ";
  put(bytes, 16, 4);
  put(bytes, 1, 2);  // PCM
  put(bytes, 1, 2);  // mono
  put(bytes, kRate, 4);
  put(bytes, kRate * kBytesPerSample, 4);
  put(bytes, kBytesPerSample, 2);
  put(bytes, 8 * kBytesPerSample, 2);
  bytes += "data";
  put(bytes, size, 4);
  return bytes;
}

}  // namespace

WavFile::WavFile(std::filesystem::path path, TemporaryFile temporary)
    : path_(std::move(path)),
      temporary_(std::move(temporary)),
      file_(temporary_.path(), std::ios::binary | std::ios::trunc) {
  file_ << header(0);
}

Result<std::unique_ptr<WavFile>> WavFile::open(const std::filesystem::path& path) {
  auto temporary = TemporaryFile::beside(path);
  if (!temporary) return temporary.error();
  return std::unique_ptr<WavFile>(new WavFile(path, std::move(*temporary)));
}

void WavFile::add(std::span<const float> samples) {
  samples = samples.first(std::min(samples.size(), kSamplesMax - samples_));
  std::string bytes;
  bytes.reserve(samples.size() * kBytesPerSample);
  for (const float sample : samples) {
    const long whole = std::lround(std::clamp(sample, -1.0F, 1.0F) * 32767);
    put(bytes, static_cast<std::uint32_t>(whole), kBytesPerSample);
  }
  file_ << bytes;
  samples_ += samples.size();
}

Result<void> WavFile::flush() {
  file_.seekp(0);
  file_ << header(samples_);
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
