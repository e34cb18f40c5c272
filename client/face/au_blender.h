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

/// Applies the rules to intensities in [0,1], each side by itself. x is the intensity of the source
/// and y that of the target, in an opposition those of its two AUs; a prime marks the result.
///   opposition    x' = max(0, x - y), y' = max(0, y - x)
///   alternative   the largest stays, the others become 0; on a tie, the first one listed stays
///   exclusion     y' = y clamp((2e - x)/e, 0, 1), e = 0.2
///   cap           y' = min(y, cap)
///   substitution  s = min(sources), y' = max(y, s), source' = source - s unless keep_sources
///   dominance     y' = y (1 - x)
/// If a rule has several sources, x is the largest of them (the smallest if all_needed). Where two
/// rules of one kind (a group of RuleSet) lower an AU, the lower value counts. If `fired` is given,
/// the rules that changed something are appended to it: first those of the left side, then those of
/// the right, each in the order of the groups. `rules` must outlive `fired`. Allocates nothing but
/// what `fired` needs to grow.
[[nodiscard]] AuFrame blend(const RuleSet& rules, const AuFrame& frame,
                            std::vector<RuleFired>* fired = nullptr);

/// An AU and how strong it is.
struct AuShare {
  int number = 0;
  int percent = 0;
  friend bool operator==(const AuShare&, const AuShare&) = default;
};

/// A rule that fired, in the form that is shown to people.
struct RuleExplained {
  const Rule* rule = nullptr;
  Side side = Side::Both;       ///< Both if it did the same on both sides
  std::vector<AuShare> before;  ///< the rule's AUs that were present
  std::vector<AuShare> after;   ///< the AUs that the rule changed; 0 %: the AU is gone
};

/// What the rules of one blend() did, left side first. A rule that did the same on both sides is
/// listed once.
[[nodiscard]] std::vector<RuleExplained> explain(std::span<const RuleFired> fired);

}  // namespace aucast::face
