#include "common/voice/wav_bytes.h"

#include <cstdint>

namespace aucast::voice {
namespace {

constexpr std::uint32_t kSampleBytes = 2;

void put(std::string& bytes, std::uint32_t value, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
  }
}

}  // namespace

std::string wav_head(std::size_t samples, int rate) {
  const std::uint32_t size = static_cast<std::uint32_t>(samples) * kSampleBytes;
  const auto samples_a_second = static_cast<std::uint32_t>(rate);
  std::string bytes = "RIFF";
  put(bytes, 36 + size, 4);
  bytes += "WAVEfmt ";
  put(bytes, 16, 4);
  put(bytes, 1, 2);  // PCM
  put(bytes, 1, 2);  // mono
  put(bytes, samples_a_second, 4);
  put(bytes, samples_a_second * kSampleBytes, 4);
  put(bytes, kSampleBytes, 2);
  put(bytes, 8 * kSampleBytes, 2);
  bytes += "data";
  put(bytes, size, 4);
  return bytes;
}

void append_wav_sample(long sample, std::string& bytes) {
  put(bytes, static_cast<std::uint32_t>(sample), kSampleBytes);
}

}  // namespace aucast::voice
