#include "client/face/au_blender.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace aucast::face {
namespace {

using Values = std::array<float, kAuCount>;

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

float largest(const std::vector<int>& numbers, const Values& values) {
  float result = 0;
  for (const int number : numbers) result = std::max(result, values[index_of(number)]);
  return result;
}

float smallest(const std::vector<int>& numbers, const Values& values) {
  float result = 1;
  for (const int number : numbers) result = std::min(result, values[index_of(number)]);
  return result;
}

std::vector<Change> opposition(const Rule& rule, const Values& before) {
  const std::size_t one = index_of(rule.sources[0]);
  const std::size_t other = index_of(rule.sources[1]);
  return {{one, std::max(0.0F, before[one] - before[other])},
          {other, std::max(0.0F, before[other] - before[one])}};
}

std::vector<Change> alternative(const Rule& rule, const Values& before) {
  const auto winner =
      *std::max_element(rule.sources.begin(), rule.sources.end(),
                        [&](int a, int b) { return before[index_of(a)] < before[index_of(b)]; });
  std::vector<Change> changes;
  for (const int number : rule.sources) {
    if (number != winner) changes.push_back({index_of(number), 0});
  }
  return changes;
}

std::vector<Change> scaled_targets(const Rule& rule, const Values& before, float factor) {
  std::vector<Change> changes;
  for (const int number : rule.targets) {
    changes.push_back({index_of(number), before[index_of(number)] * factor});
  }
  return changes;
}

std::vector<Change> cap(const Rule& rule, const Values& before) {
  std::vector<Change> changes;
  if (largest(rule.sources, before) <= 0) return changes;
  for (const int number : rule.targets) {
    changes.push_back({index_of(number), std::min(before[index_of(number)], rule.cap)});
  }
  return changes;
}

std::vector<Change> substitution(const Rule& rule, const Values& before) {
  const float share = smallest(rule.sources, before);
  if (share <= 0) return {};
  std::vector<Change> changes{{index_of(rule.targets[0]), share, true}};
  if (rule.keep_sources) return changes;
  for (const int number : rule.sources) {
    changes.push_back({index_of(number), before[index_of(number)] - share});
  }
  return changes;
}

/// The formulas of data/rules/README.md.
std::vector<Change> changes_of(const Rule& rule, const Values& before) {
  switch (rule.kind) {
    case RuleKind::Opposition:
      return opposition(rule, before);
    case RuleKind::Alternative:
      return alternative(rule, before);
    case RuleKind::Exclusion: {
      const float left_over = (2 * kMinute - largest(rule.sources, before)) / kMinute;
      return scaled_targets(rule, before, std::clamp(left_over, 0.0F, 1.0F));
    }
    case RuleKind::Cap:
      return cap(rule, before);
    case RuleKind::Substitution:
      return substitution(rule, before);
    case RuleKind::Dominance:
      return scaled_targets(rule, before, 1 - largest(rule.sources, before));
    case RuleKind::MultipleDominance:
      return scaled_targets(
          rule, before,
          1 - (rule.all_needed ? smallest(rule.sources, before) : largest(rule.sources, before)));
    case RuleKind::Additive:
    case RuleKind::Different:
      break;
  }
  return {};
}

bool changes_something(const Change& change, const Values& before) {
  return change.raises ? change.value > before[change.number]
                       : change.value < before[change.number];
}

std::string percent(float value) {
  return std::to_string(std::lround(std::clamp(value, 0.0F, 1.0F) * 100)) + " %";
}

/// "51 100 % and 52 40 %: 51 60 %, 52 gone".
std::string told(const Rule& rule, const Values& before, std::span<const Change> changes) {
  std::string present;
  std::vector<int> named = rule.sources;
  named.insert(named.end(), rule.targets.begin(), rule.targets.end());
  for (const int number : named) {
    if (before[index_of(number)] <= 0) continue;
    present += (present.empty() ? "" : " and ") + std::to_string(number) + " " +
               percent(before[index_of(number)]);
  }
  std::string after;
  for (const Change& change : changes) {
    if (!changes_something(change, before)) continue;
    after += (after.empty() ? "" : ", ") + std::to_string(change.number) + " " +
             (change.value > 0 ? percent(change.value) : "gone");
  }
  return present + ": " + after;
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
void apply_group(const RuleSet& rules, Belongs belongs, Values& values, Side side,
                 std::vector<RuleFired>& fired) {
  const Values before = values;
  Values raised{};
  for (const Rule& rule : rules.rules) {
    if (!belongs(rule)) continue;
    const std::vector<Change> changes = changes_of(rule, before);
    const auto matters = [&](const Change& change) { return changes_something(change, before); };
    if (std::none_of(changes.begin(), changes.end(), matters)) continue;
    fired.push_back({&rule, side, told(rule, before, changes)});
    for (const Change& change : changes) {
      float& limit = change.raises ? raised[change.number] : values[change.number];
      limit = change.raises ? std::max(limit, change.value) : std::min(limit, change.value);
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::max(values[i], raised[i]);
}

Values blend_side(const RuleSet& rules, Values values, Side side, std::vector<RuleFired>& fired) {
  if (rules.all_read_input) {
    apply_group(
        rules, [](const Rule&) { return true; }, values, side, fired);
    return values;
  }
  for (int group = 1; group <= kGroupLast; ++group) {
    const auto belongs = [group](const Rule& rule) { return group_of(rule.kind) == group; };
    apply_group(rules, belongs, values, side, fired);
  }
  return values;
}

/// Joins what happened alike on both sides.
void add_fired(std::vector<RuleFired>& fired, std::vector<RuleFired> left,
               std::vector<RuleFired> right) {
  for (RuleFired& one : left) {
    const auto twin = std::find_if(right.begin(), right.end(), [&](const RuleFired& other) {
      return other.rule == one.rule && other.what == one.what;
    });
    if (twin != right.end()) {
      one.side = Side::Both;
      right.erase(twin);
    }
    fired.push_back(std::move(one));
  }
  std::move(right.begin(), right.end(), std::back_inserter(fired));
}

}  // namespace

AuFrame blend(const RuleSet& rules, const AuFrame& frame, std::vector<RuleFired>* fired) {
  AuFrame result = frame;
  std::vector<RuleFired> left;
  std::vector<RuleFired> right;
  result.left = blend_side(rules, result.left, Side::Left, left);
  result.right = blend_side(rules, result.right, Side::Right, right);
  if (fired != nullptr) add_fired(*fired, std::move(left), std::move(right));
  return result;
}

}  // namespace aucast::face
