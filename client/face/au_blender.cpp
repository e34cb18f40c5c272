#include "client/face/au_blender.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace aucast::face {
namespace {

/// An excluding AU below this is minute and excludes nothing; from twice this it excludes wholly.
constexpr float kMinute = 0.2F;

/// What a rule does to one AU, on its own. Lowering sets an upper limit, raising a lower one, so
/// that rules of one group can be joined in any order.
struct Change {
  std::size_t number = 0;
  float value = 0;
  bool raises = false;
};

std::size_t index_of(int number) {
  return static_cast<std::size_t>(number);
}

float largest(const std::vector<int>& numbers, const Intensities& values) {
  float result = 0;
  for (const int number : numbers) result = std::max(result, values[index_of(number)]);
  return result;
}

float smallest(const std::vector<int>& numbers, const Intensities& values) {
  float result = 1;
  for (const int number : numbers) result = std::min(result, values[index_of(number)]);
  return result;
}

int strongest(const std::vector<int>& numbers, const Intensities& values) {
  return *std::max_element(numbers.begin(), numbers.end(),
                           [&](int a, int b) { return values[index_of(a)] < values[index_of(b)]; });
}

/// The share of an excluded or dominated AU that is left.
float share_left(const Rule& rule, const Intensities& before) {
  const float source = rule.all_needed && rule.kind == RuleKind::MultipleDominance
                           ? smallest(rule.sources, before)
                           : largest(rule.sources, before);
  if (rule.kind != RuleKind::Exclusion) return 1 - source;
  return std::clamp((2 * kMinute - source) / kMinute, 0.0F, 1.0F);
}

/// The formulas of data/rules/README.md: hands each Change of the rule to `visit`.
template <typename Visit>
void for_each_change(const Rule& rule, const Intensities& before, Visit visit) {
  const auto value = [&](int number) { return before[index_of(number)]; };
  const auto lower = [&](int number, float to) { visit(Change{index_of(number), to, false}); };
  switch (rule.kind) {
    case RuleKind::Opposition: {
      const float difference = value(rule.sources[0]) - value(rule.sources[1]);
      lower(rule.sources[0], std::max(0.0F, difference));
      lower(rule.sources[1], std::max(0.0F, -difference));
      return;
    }
    case RuleKind::Alternative: {
      const int winner = strongest(rule.sources, before);
      for (const int number : rule.sources) {
        if (number != winner) lower(number, 0);
      }
      return;
    }
    case RuleKind::Cap:
      if (largest(rule.sources, before) <= 0) return;
      for (const int number : rule.targets) lower(number, std::min(value(number), rule.cap));
      return;
    case RuleKind::Substitution: {
      const float share = smallest(rule.sources, before);
      if (share <= 0) return;
      visit(Change{index_of(rule.targets[0]), share, true});
      if (rule.keep_sources) return;
      for (const int number : rule.sources) lower(number, value(number) - share);
      return;
    }
    case RuleKind::Exclusion:
    case RuleKind::Dominance:
    case RuleKind::MultipleDominance: {
      const float share = share_left(rule, before);
      for (const int number : rule.targets) lower(number, value(number) * share);
      return;
    }
    case RuleKind::Additive:
    case RuleKind::Different:
      return;
  }
}

bool changes_something(const Change& change, const Intensities& before) {
  return change.raises ? change.value > before[change.number]
                       : change.value < before[change.number];
}

/// What the rule read and what it changed.
RuleExplained explained_by(const Rule& rule, Side side, const Intensities& before) {
  RuleExplained one{&rule, side, {}, {}};
  std::vector<int> named = rule.sources;
  named.insert(named.end(), rule.targets.begin(), rule.targets.end());
  for (const int number : named) {
    const float value = before[index_of(number)];
    if (value > 0) one.before.push_back({number, percent_of(value)});
  }
  for_each_change(rule, before, [&](const Change& change) {
    if (!changes_something(change, before)) return;
    const int percent = change.value > 0 ? percent_of(change.value) : 0;
    one.after.push_back({static_cast<int>(change.number), percent});
  });
  return one;
}

/// The groups of data/rules/README.md, one after the other; 0 for rules that change nothing.
int group_of(RuleKind kind) {
  switch (kind) {
    case RuleKind::Opposition:
      return 1;
    case RuleKind::Alternative:
      return 2;
    case RuleKind::Exclusion:
      return 3;
    case RuleKind::Cap:
      return 4;
    case RuleKind::Substitution:
      return 5;
    case RuleKind::Dominance:
    case RuleKind::MultipleDominance:
      return 6;
    case RuleKind::Additive:
    case RuleKind::Different:
      break;
  }
  return 0;
}
constexpr int kGroupLast = 6;

/// Applies rules that all read the same values: limits meet at the lowest, and what a substitution
/// brings counts after them.
template <typename Belongs>
void apply_group(const RuleSet& rules, Belongs belongs, Intensities& values, Side side,
                 std::vector<RuleFired>* fired) {
  const Intensities before = values;
  Intensities raised{};
  for (const Rule& rule : rules.rules) {
    if (!belongs(rule)) continue;
    bool matters = false;
    for_each_change(rule, before,
                    [&](const Change& change) { matters |= changes_something(change, before); });
    if (!matters) continue;
    if (fired != nullptr) fired->push_back({&rule, side, before});
    for_each_change(rule, before, [&](const Change& change) {
      float& limit = change.raises ? raised[change.number] : values[change.number];
      limit = change.raises ? std::max(limit, change.value) : std::min(limit, change.value);
    });
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::max(values[i], raised[i]);
}

void blend_side(const RuleSet& rules, Intensities& values, Side side,
                std::vector<RuleFired>* fired) {
  if (rules.all_read_input) {
    apply_group(
        rules, [](const Rule&) { return true; }, values, side, fired);
    return;
  }
  for (int group = 1; group <= kGroupLast; ++group) {
    const auto belongs = [group](const Rule& rule) { return group_of(rule.kind) == group; };
    apply_group(rules, belongs, values, side, fired);
  }
}

}  // namespace

AuFrame blend(const RuleSet& rules, const AuFrame& frame, std::vector<RuleFired>* fired) {
  AuFrame result = frame;
  blend_side(rules, result.left, Side::Left, fired);
  blend_side(rules, result.right, Side::Right, fired);
  return result;
}

std::vector<RuleExplained> explain(std::span<const RuleFired> fired) {
  std::vector<RuleExplained> explained;
  for (const RuleFired& one : fired) {
    RuleExplained next = explained_by(*one.rule, one.side, one.before);
    const auto twin =
        std::find_if(explained.begin(), explained.end(), [&](const RuleExplained& other) {
          return other.rule == next.rule && other.side != next.side &&
                 other.before == next.before && other.after == next.after;
        });
    if (twin != explained.end()) {
      twin->side = Side::Both;
    } else {
      explained.push_back(std::move(next));
    }
  }
  return explained;
}

}  // namespace aucast::face
