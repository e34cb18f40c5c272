#pragma once

#include <string>

#include "common/sources/recording.h"

namespace aucast::sources {

/// What was found, one line each: "  format      OpenFace 2".
[[nodiscard]] std::string found_lines(const Found& found);
/// The same in a sentence, for the log.
[[nodiscard]] std::string found_sentence(const Found& found);

}  // namespace aucast::sources
