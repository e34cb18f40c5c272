#pragma once

#include <string>
#include <vector>

#include "common/sources/per_au.h"
#include "common/sources/signals.h"

namespace aucast::sources {

/// An AU that is too strong for a face at rest.
struct LoudAu {
  AuName au;
  int percent = 0;
  friend bool operator==(const LoudAu&, const LoudAu&) = default;
};

/// The strongest that an AU of a face at rest may be; recognisers see up to 25 % in one.
inline constexpr double kRestPercentMax = 30;

/// The AUs of a neutral face that are stronger than kRestPercentMax, the strongest first. Turns of
/// head and eyes do not count, since the camera may be to one side.
[[nodiscard]] std::vector<LoudAu> loud_aus(const Signals& neutral);

/// "AU12 100 %, AU1 40 %: no face at rest was taken off": what is to be known of these.
[[nodiscard]] std::string unquiet_text(const std::vector<LoudAu>& loud);

/// The strongest few: "AU7 100 %, AU20 100 %, AUL10 77 % and 12 more".
[[nodiscard]] std::string loud_text(const std::vector<LoudAu>& loud);

}  // namespace aucast::sources
