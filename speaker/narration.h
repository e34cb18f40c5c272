#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "common/result.h"
#include "common/time.h"

namespace aucast::speaker {

/// The longest narration that is read. It is held in memory, 230 MB for each hour.
inline constexpr Milliseconds kNarrationMax = std::chrono::hours(3);

struct Narration {
  std::vector<float> samples;  ///< mono, in [-1,1], at voice::kEncoderRate
  std::string complaint;       ///< as SoundFile::complaint()
};

/// Reads the narration of a text that takes the synthesiser `said`. Unreadable as
/// SoundFile::open(); BadData when it is no sound, is damaged, lasts longer than `longest`, or less
/// than a quarter of `said` or more than four times that.
[[nodiscard]] Result<Narration> read_narration(const std::filesystem::path& path, Milliseconds said,
                                               Milliseconds longest = kNarrationMax);

}  // namespace aucast::speaker
