#pragma once

#include <string>
#include <vector>

#include "common/sources/neutral.h"
#include "common/sources/per_au.h"

namespace aucast::sources {

/// An AU that is too strong for a neutral face, or moves too far for a face at rest.
struct LoudAu {
  AuName au;
  int percent = 0;
  bool moves = false;  ///< `percent` is how far it moves; else how strong it is
  friend bool operator==(const LoudAu&, const LoudAu&) = default;
};

/// How strong an AU of a neutral face may be, and how far it may move. Recognisers see AUs of up to
/// 25 % in neutral faces.
inline constexpr double kNeutralPercentMax = 30;

/// The AUs that are stronger than kNeutralPercentMax in what is taken for a neutral face, the
/// strongest first. If there are none: the AUs that move by more than that. What is taken for the
/// neutral face is a median, so its AUs can be weak even if the face talked or grimaced; how far
/// they moved shows that. Turns of head and eyes do not count, since the camera may be to one side,
/// nor do movements of the eyelids, which blink and follow the eyes.
[[nodiscard]] std::vector<LoudAu> loud_aus(const MeasuredNeutral& neutral);

/// What to tell the user about these AUs: "AU12 100 %, AU1 40 %: no neutral face was subtracted".
[[nodiscard]] std::string not_neutral_text(const std::vector<LoudAu>& loud);

/// The strongest few: "AU7 100 %, AU20 100 %, AUL10 77 % and 12 more", "movement of AU4 73 %".
[[nodiscard]] std::string loud_text(const std::vector<LoudAu>& loud);

}  // namespace aucast::sources
