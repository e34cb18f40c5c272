#pragma once

#include <string>
#include <vector>

#include "common/sources/per_au.h"
#include "common/sources/signals.h"

namespace aucast::sources {

/// An AU that is stronger than a face at rest has it.
struct LoudAu {
  AuName au;
  int percent = 0;
  friend bool operator==(const LoudAu&, const LoudAu&) = default;
};

/// No AU of a face at rest is stronger: recognisers see up to a quarter in one.
inline constexpr double kRestPercentMax = 30;

/// The AUs of a neutral face that are stronger than kRestPercentMax, the strongest first. Where
/// head and eyes are turned to says nothing: a camera may stand aside.
[[nodiscard]] std::vector<LoudAu> loud_aus(const Signals& neutral);

/// "AU12 100 %, AU1 40 %: no face at rest was taken off": what is to be known of these.
[[nodiscard]] std::string unquiet_text(const std::vector<LoudAu>& loud);

/// The strongest few: "AU7 100 %, AU20 100 %, AUL10 77 % and 12 more".
[[nodiscard]] std::string loud_text(const std::vector<LoudAu>& loud);

}  // namespace aucast::sources
