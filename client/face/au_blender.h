#pragma once

#include <string>
#include <vector>

#include "client/face/co_occurrence_rules.h"
#include "common/action_unit.h"

namespace aucast::face {

/// One rule that changed something, for --explain.
struct RuleFired {
  const Rule* rule = nullptr;
  Side side = Side::Both;  ///< Both when it changed both sides alike
  std::string what;        ///< "51 100 % and 52 40 %: 51 60 %, 52 gone"
};

/// Applies the rules to intensities, each side by itself.
/// Opposition x' = max(0, x-y), y' = max(0, y-x); alternative: the larger stays, on a tie the one
/// listed first; exclusion y' = y clamp((2e - x)/e, 0, 1) with e = 0.2; cap y' = min(y, cap);
/// substitution s = min(sources), target' = max(target, s), sources - s; dominance y' = y (1 - x);
/// x of several sources is the largest (or smallest, where all are needed). Where two rules of one
/// group lower an AU, the lower value counts. Intensities are in [0,1]. Adds to `fired` what
/// happened when it is given, group by group; the rules must outlive that.
[[nodiscard]] AuFrame blend(const RuleSet& rules, const AuFrame& frame,
                            std::vector<RuleFired>* fired = nullptr);

}  // namespace aucast::face
