#pragma once

#include <string>
#include <vector>

#include "common/sources/per_au.h"
#include "common/sources/signals.h"

namespace aucast::sources {

/// An AU that is too strong for a neutral face.
struct LoudAu {
  AuName au;
  int percent = 0;
  friend bool operator==(const LoudAu&, const LoudAu&) = default;
};

/// The strongest that an AU of a neutral face may be; recognisers see up to 25 % in one.
inline constexpr double kNeutralPercentMax = 30;

/// The AUs of what is taken for a neutral face that are stronger than kNeutralPercentMax, the
/// strongest first. Turns of head and eyes do not count, since the camera may be to one side.
[[nodiscard]] std::vector<LoudAu> loud_aus(const Signals& neutral);

/// "AU12 100 %, AU1 40 %: no neutral face was taken off": what is to be known of these.
[[nodiscard]] std::string not_neutral_text(const std::vector<LoudAu>& loud);

/// The strongest few: "AU7 100 %, AU20 100 %, AUL10 77 % and 12 more".
[[nodiscard]] std::string loud_text(const std::vector<LoudAu>& loud);

}  // namespace aucast::sources
