#pragma once

#include <string>
#include <vector>

#include "common/sources/recording.h"

namespace aucast::sources {

/// Reasons to doubt the keyframes, one sentence each: a clock faster than any camera's, a clock
/// that does not advance, the subtraction of a face that is not neutral.
[[nodiscard]] std::vector<std::string> warnings(const Found& found, const SettingNames& names = {});

/// What was found, one line each: "  format      OpenFace 2".
[[nodiscard]] std::string found_lines(const Found& found);
/// The same in one sentence, for the log.
[[nodiscard]] std::string found_sentence(const Found& found);

}  // namespace aucast::sources
