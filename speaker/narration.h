#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/result.h"
#include "common/time.h"
#include "speaker/speech.h"

namespace aucast::speaker {

struct Narration {
  std::vector<float> samples;  ///< mono, in [-1,1], at voice::kEncoderRate
  std::string complaint;       ///< as SoundFile::complaint()
};

/// Reads the narration of a text; `said` is how long the synthesiser takes to speak that text.
/// Fails with Unreadable as SoundFile::open() does. Fails with BadData if the file is no sound or
/// is damaged, or if it lasts longer than `longest`, less than a quarter of `said` or more than
/// four times `said`.
[[nodiscard]] Result<Narration> read_narration(const std::filesystem::path& path, Milliseconds said,
                                               Milliseconds longest = kSpeechMax);

}  // namespace aucast::speaker
