#pragma once

#include <string>
#include <string_view>

#include "common/result.h"
#include "common/sources/conditioning.h"

namespace aucast::sources {

// === Ranges, for profiles and for options alike

inline constexpr double kGainMax = 10;
inline constexpr double kDeadBandMax = 50;  ///< percent
inline constexpr double kCutoffMax = 100;   ///< Hz
inline constexpr double kBetaMax = 100;
inline constexpr double kNeutralMax = 1000;  ///< percent; more than 100, since heads turn further

/// Reads a profile: TOML with the tables [neutral], [gain], [dead-band] and [filter], each of which
/// may be missing; SIGNALS.md in this folder describes them. Fails with BadData and
/// file:line:column.
[[nodiscard]] Result<Profile> parse_profile(std::string_view text, std::string_view file);

/// The profile as text. parse_profile() reads the same profile from it, except that the neutral
/// face is rounded to a hundredth of a percent and a tenth of a millimetre.
[[nodiscard]] std::string format_profile(const Profile& profile);

/// For the log: "measured in 60 rows of 2 s: 1 4 %, L12 8 %, 54 20 %"; AUs below 1 % are left out.
[[nodiscard]] std::string measured_text(const MeasuredNeutral& neutral);

}  // namespace aucast::sources
