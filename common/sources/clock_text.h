#pragma once

#include <optional>
#include <string_view>

namespace aucast::sources {

/// A time code HH:MM:SS:FF.fff, taken apart.
struct Timecode {
  double whole_seconds = 0;  ///< since midnight
  double frames = 0;
};

[[nodiscard]] std::optional<Timecode> parse_timecode(std::string_view text);

/// HH:MM:SS.fff as seconds; nullopt for any other text.
[[nodiscard]] std::optional<double> parse_clock(std::string_view text);

}  // namespace aucast::sources
