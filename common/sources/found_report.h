#pragma once

#include <string>
#include <vector>

#include "common/sources/recording.h"

namespace aucast::sources {

/// What the user should know before believing the keyframes, a sentence each: a clock that no
/// camera has, a clock that stands still, a quiet face that was none.
[[nodiscard]] std::vector<std::string> warnings(const Found& found, const SettingNames& names = {});

/// What was found, one line each: "  format      OpenFace 2".
[[nodiscard]] std::string found_lines(const Found& found);
/// The same in a sentence, for the log.
[[nodiscard]] std::string found_sentence(const Found& found);

}  // namespace aucast::sources
