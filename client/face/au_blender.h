#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "client/face/co_occurrence_rules.h"
#include "common/action_unit.h"

namespace aucast::face {

/// The intensities of one side by AU number, in [0,1].
using Intensities = std::array<float, kAuCount>;

/// One rule that changed something on one side.
struct RuleFired {
  const Rule* rule = nullptr;
  Side side = Side::Left;  ///< Left or Right
  Intensities before{};    ///< what the rule read
};

/// Applies the rules to intensities in [0,1], each side by itself. With x the source, y the target
/// and a prime for the result:
///   opposition    x' = max(0, x - y), y' = max(0, y - x)
///   alternative   the larger stays; on a tie, the one listed first
///   exclusion     y' = y clamp((2e - x)/e, 0, 1), e = 0.2
///   cap           y' = min(y, cap)
///   substitution  s = min(sources), y' = max(y, s), each source' = source - s
///   dominance     y' = y (1 - x)
/// x of several sources is the largest (the smallest, where all are needed). Where two rules of one
/// group lower an AU, the lower value counts. Appends the rules that changed something to `fired`
/// when it is given: the left side's, then the right side's, each group by group. The rules must
/// outlive it. Allocates nothing but what `fired` needs to grow.
[[nodiscard]] AuFrame blend(const RuleSet& rules, const AuFrame& frame,
                            std::vector<RuleFired>* fired = nullptr);

/// An AU and how strong it is.
struct AuShare {
  int number = 0;
  int percent = 0;
  friend bool operator==(const AuShare&, const AuShare&) = default;
};

/// A rule that fired, for people.
struct RuleExplained {
  const Rule* rule = nullptr;
  Side side = Side::Both;       ///< Both when it changed both sides alike
  std::vector<AuShare> before;  ///< those of its AUs that were there
  std::vector<AuShare> after;   ///< those that it changed; 0: gone
};

/// What the rules of one blend() did, left side first; alike on both sides is said once.
[[nodiscard]] std::vector<RuleExplained> explain(std::span<const RuleFired> fired);

}  // namespace aucast::face
