#pragma once

#include <cstddef>
#include <string>

namespace aucast::voice {

/// The head of a WAV file of `samples` mono samples of 16 bits, `rate` a second. Its sizes have 32
/// bits, which the samples must fit.
[[nodiscard]] std::string wav_head(std::size_t samples, int rate);

/// Appends a sample, -32768 to 32767, to `bytes` as such a file has it.
void append_wav_sample(long sample, std::string& bytes);

}  // namespace aucast::voice
