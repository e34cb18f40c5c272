#include "client/face/au_blender.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "tests/support/allocations.h"
#include "tests/support/seeded.h"
#include "tests/unit/face/shipped_data.h"

namespace aucast::face {
namespace {

using aucast::test::Seeded;
using Terms = std::vector<AuTerm>;
using test::kData;

RuleSet profile(std::string_view name) {
  auto rules = find_rules(name, kData);
  EXPECT_TRUE(rules.has_value()) << (rules.has_value() ? "" : rules.error().message);
  return rules.has_value() ? *std::move(rules) : RuleSet{};
}

Rule rule(RuleKind kind, std::vector<int> sources, std::vector<int> targets = {}) {
  Rule result;
  result.kind = kind;
  result.sources = std::move(sources);
  result.targets = std::move(targets);
  return result;
}

RuleSet one(Rule only) {
  return {"one", false, {std::move(only)}};
}

AuFrame set_of(const std::vector<int>& numbers) {
  Terms terms;
  for (const int number : numbers) {
    terms.push_back({static_cast<std::uint8_t>(number), Side::Both, 100});
  }
  return frame_from_terms(terms);
}

Terms blended(const RuleSet& rules, const Terms& terms) {
  return canonical_terms(blend(rules, frame_from_terms(terms)));
}

Terms blended_set(const RuleSet& rules, const std::vector<int>& numbers) {
  return canonical_terms(blend(rules, set_of(numbers)));
}

AuFrame random_frame(Seeded& seeded, const std::vector<int>& numbers) {
  AuFrame frame;
  for (const int number : numbers) {
    const auto i = static_cast<std::size_t>(number);
    if (seeded.chance(0.6)) frame.left[i] = static_cast<float>(seeded.real(0, 1));
    if (seeded.chance(0.6)) frame.right[i] = static_cast<float>(seeded.real(0, 1));
  }
  return frame;
}

std::vector<int> numbers_in(const RuleSet& rules) {
  std::set<int> numbers;
  for (const Rule& each : rules.rules) {
    numbers.insert(each.sources.begin(), each.sources.end());
    numbers.insert(each.targets.begin(), each.targets.end());
  }
  return {numbers.begin(), numbers.end()};
}

/// Table 5.4: what was sent, and what the thesis' rules made of it.
struct Row {
  std::string name;
  std::vector<int> sent;
  std::vector<int> resulting;
};
const std::vector<Row> kTable54 = {
    {"surprise", {1, 2, 5, 15, 16, 20, 26}, {2, 5, 11, 15, 26}},
    {"fear", {1, 2, 4, 5, 15, 20, 26}, {2, 4, 5, 11, 15, 26}},
    {"disgust", {2, 4, 9, 15, 17}, {2, 4, 9, 11, 15, 17}},
    {"anger", {2, 4, 7, 9, 10, 20, 26}, {2, 4, 9, 11, 15, 26}},
    {"happiness", {1, 6, 12, 14}, {6, 11, 14, 15}},
    {"sadness", {1, 4, 15, 23}, {4, 11, 15, 23}},
};

TEST(Blender, Kumar2010IsTable54) {
  const RuleSet rules = profile("kumar2010");
  for (const Row& row : kTable54) {
    EXPECT_EQ(blend(rules, set_of(row.sent)), set_of(row.resulting)) << row.name;
  }
}

TEST(Blender, FacsAndNoneLeaveTable54Unchanged) {
  for (const auto* name : {"facs", "none"}) {
    const RuleSet rules = profile(name);
    for (const Row& row : kTable54) {
      EXPECT_EQ(blend(rules, set_of(row.sent)), set_of(row.sent)) << name << ", " << row.name;
    }
  }
}

TEST(Blender, NoneLeavesEverything) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const RuleSet none = profile("none");
  for (int run = 0; run < 100; ++run) {
    const AuFrame frame = random_frame(seeded, {1, 5, 7, 13, 14, 18, 28, 43, 45, 46, 51, 52});
    EXPECT_EQ(blend(none, frame), frame);
  }
}

TEST(Blender, FacsLeavesWhatFacsCombines) {
  const RuleSet rules = profile("facs");
  const std::vector<std::vector<int>> combinations = {
      {1, 4},   {1, 2, 4},    {4, 9},       {6, 7},       {6, 12},          {9, 10},
      {10, 12}, {12, 14},     {12, 15},     {12, 17},     {12, 20},         {15, 17},
      {15, 20}, {16, 20},     {16, 25},     {20, 26},     {22, 23},         {23, 24},
      {25, 26}, {12, 18, 23}, {12, 20, 23}, {17, 22, 23}, {10, 12, 16, 25}, {4, 7, 23}};
  for (const auto& combination : combinations) {
    EXPECT_EQ(blend(rules, set_of(combination)), set_of(combination)) << combination[0];
  }
}

/// Every pair of FACS 2002's list of mutually exclusive codes and what is left of it at full
/// intensity: one of the two, nothing (opposite movements), or both with a cap.
TEST(Blender, FacsResolvesEveryExclusivePair) {
  const RuleSet rules = profile("facs");
  const std::vector<std::pair<std::pair<int, int>, std::vector<int>>> pairs = {
      {{5, 43}, {43}},  {{5, 45}, {45}},  {{43, 45}, {45}}, {{43, 46}, {43}}, {{45, 46}, {45}},
      {{16, 28}, {28}}, {{18, 28}, {18}}, {{22, 28}, {22}}, {{24, 25}, {25}}, {{26, 27}, {27}},
      {{8, 24}, {8}},   {{8, 34}, {8}},   {{26, 31}, {26}}, {{27, 31}, {27}}, {{27, 32}, {27}},
      {{28, 31}, {28}}, {{28, 32}, {28}}, {{19, 24}, {19}}, {{19, 31}, {19}}, {{19, 36}, {19}},
      {{19, 37}, {19}}, {{24, 33}, {24}}, {{24, 37}, {24}}, {{25, 34}, {25}}, {{31, 36}, {31}},
      {{31, 37}, {31}}, {{32, 37}, {32}}, {{33, 34}, {33}}, {{33, 35}, {33}}, {{34, 35}, {34}},
      {{36, 37}, {36}}, {{38, 39}, {38}}, {{51, 52}, {}},   {{53, 54}, {}},   {{55, 56}, {}},
      {{57, 58}, {}},   {{61, 62}, {}},   {{63, 64}, {}},   {{61, 65}, {61}}, {{61, 66}, {61}},
      {{62, 65}, {62}}, {{62, 66}, {62}}, {{65, 66}, {65}}};
  for (const auto& [pair, expected] : pairs) {
    const std::string what = std::to_string(pair.first) + "+" + std::to_string(pair.second);
    const AuFrame result = blend(rules, set_of({pair.first, pair.second}));
    EXPECT_EQ(result.right, set_of(expected).right) << what;
    // A wink is one eye's: the other side keeps what it removes.
    if (shows_on_one_side(pair.first) || shows_on_one_side(pair.second)) continue;
    EXPECT_EQ(result.left, set_of(expected).left) << what;
  }
  EXPECT_EQ(blended_set(rules, {5, 7}), (Terms{{5, Side::Both, 100}, {7, Side::Both, 80}}));
  EXPECT_EQ(blended_set(rules, {5, 46}), (Terms{{5, Side::Left, 100}, {46, Side::Right, 100}}));
}

TEST(Blender, TheLargerOfAlternativesWinsAndATieGoesToTheFirst) {
  const RuleSet rules = one(rule(RuleKind::Alternative, {27, 26}));
  EXPECT_EQ(blended(rules, {{26, Side::Both, 60}, {27, Side::Both, 50}}),
            (Terms{{26, Side::Both, 60}}));
  EXPECT_EQ(blended(rules, {{26, Side::Both, 50}, {27, Side::Both, 50}}),
            (Terms{{27, Side::Both, 50}}));
  EXPECT_EQ(blended(rules, {{26, Side::Both, 50}}), (Terms{{26, Side::Both, 50}}));
}

TEST(Blender, OnlyTheDifferenceOfOppositesRemains) {
  const RuleSet rules = one(rule(RuleKind::Opposition, {51, 52}));
  EXPECT_EQ(blended(rules, {{51, Side::Both, 100}, {52, Side::Both, 40}}),
            (Terms{{51, Side::Both, 60}}));
  EXPECT_EQ(blended(rules, {{51, Side::Both, 40}, {52, Side::Both, 40}}),
            (Terms{{0, Side::Both, 100}}));
}

TEST(Blender, AMinuteAuExcludesNothing) {
  const RuleSet rules = one(rule(RuleKind::Exclusion, {18}, {28}));
  const auto left_of_28 = [&](std::uint8_t percent) {
    return blend(rules, frame_from_terms(Terms{{18, Side::Both, percent}, {28, Side::Both, 100}}))
        .left[28];
  };
  EXPECT_FLOAT_EQ(left_of_28(10), 1.0F);
  EXPECT_FLOAT_EQ(left_of_28(20), 1.0F);
  EXPECT_NEAR(left_of_28(30), 0.5F, 1e-6F);
  EXPECT_FLOAT_EQ(left_of_28(40), 0.0F);
  EXPECT_FLOAT_EQ(left_of_28(100), 0.0F);
}

TEST(Blender, ACapHoldsWhileASourceIsThere) {
  Rule capped = rule(RuleKind::Cap, {5}, {7});
  capped.cap = 0.8F;
  const RuleSet rules = one(capped);
  EXPECT_EQ(blended(rules, {{5, Side::Both, 1}, {7, Side::Both, 100}}),
            (Terms{{5, Side::Both, 1}, {7, Side::Both, 80}}));
  EXPECT_EQ(blended(rules, {{5, Side::Both, 100}, {7, Side::Both, 50}}),
            (Terms{{5, Side::Both, 100}, {7, Side::Both, 50}}));
  EXPECT_EQ(blended(rules, {{7, Side::Both, 100}}), (Terms{{7, Side::Both, 100}}));
}

TEST(Blender, SubstitutionTakesItsShareFromTheSources) {
  const RuleSet rules = one(rule(RuleKind::Substitution, {13, 14}, {12}));
  EXPECT_EQ(blended_set(rules, {13, 14}), (Terms{{12, Side::Both, 100}}));
  EXPECT_EQ(blended(rules, {{13, Side::Both, 80}, {14, Side::Both, 30}}),
            (Terms{{12, Side::Both, 30}, {13, Side::Both, 50}}));
  EXPECT_EQ(blended(rules, {{12, Side::Both, 90}, {13, Side::Both, 30}, {14, Side::Both, 30}}),
            (Terms{{12, Side::Both, 90}}));
  EXPECT_EQ(blended(rules, {{13, Side::Both, 80}}), (Terms{{13, Side::Both, 80}}));
}

TEST(Blender, SubstitutionMayKeepItsSources) {
  Rule implied = rule(RuleKind::Substitution, {9}, {11});
  implied.keep_sources = true;
  EXPECT_EQ(blended(one(implied), {{9, Side::Both, 70}}),
            (Terms{{9, Side::Both, 70}, {11, Side::Both, 70}}));
}

TEST(Blender, DominanceFadesItsTargets) {
  const RuleSet rules = one(rule(RuleKind::Dominance, {9}, {10, 7}));
  EXPECT_EQ(blended(rules, {{7, Side::Both, 50}, {9, Side::Both, 60}, {10, Side::Both, 100}}),
            (Terms{{7, Side::Both, 20}, {9, Side::Both, 60}, {10, Side::Both, 40}}));
  EXPECT_EQ(blended_set(rules, {7, 9, 10}), (Terms{{9, Side::Both, 100}}));
}

TEST(Blender, MultipleDominanceTakesTheLargestOrNeedsAll) {
  Rule any = rule(RuleKind::MultipleDominance, {1, 2}, {4});
  const Terms terms{{1, Side::Both, 80}, {2, Side::Both, 25}, {4, Side::Both, 100}};
  EXPECT_FLOAT_EQ(blend(one(any), frame_from_terms(terms)).left[4], 0.2F);
  any.all_needed = true;
  EXPECT_FLOAT_EQ(blend(one(any), frame_from_terms(terms)).left[4], 0.75F);
  EXPECT_EQ(blended_set(one(any), {1, 4}), (Terms{{1, Side::Both, 100}, {4, Side::Both, 100}}));
}

TEST(Blender, AdditiveAndDifferentChangeNothing) {
  for (const RuleKind kind : {RuleKind::Additive, RuleKind::Different}) {
    std::vector<RuleFired> fired;
    EXPECT_EQ(blend(one(rule(kind, {1, 26})), set_of({1, 26}), &fired), set_of({1, 26}));
    EXPECT_TRUE(fired.empty());
  }
}

TEST(Blender, EachSideIsBlendedByItself) {
  const RuleSet rules = one(rule(RuleKind::Dominance, {9}, {10}));
  EXPECT_EQ(blended(rules, {{9, Side::Left, 100}, {10, Side::Both, 80}}),
            (Terms{{9, Side::Left, 100}, {10, Side::Right, 80}}));
}

TEST(Blender, WhatShowsOnOneSideIsTheRightOnesUnlessBothAreNamed) {
  const RuleSet rules = profile("facs");
  EXPECT_EQ(blended_set(rules, {46}), (Terms{{46, Side::Right, 100}}));
  EXPECT_EQ(blended(rules, {{36, Side::Both, 50}, {37, Side::Right, 100}}),
            (Terms{{37, Side::Right, 100}}))
      << "36 is not on the left, where nothing excludes it";
  EXPECT_EQ(blended(rules, {{46, Side::Left, 100}, {46, Side::Right, 100}}),
            (Terms{{46, Side::Left, 100}, {46, Side::Right, 100}}));
  EXPECT_EQ(blended(rules, {{46, Side::Left, 100}, {5, Side::Both, 100}}),
            (Terms{{5, Side::Right, 100}, {46, Side::Left, 100}}));
  EXPECT_EQ(blended_set(rules, {43, 46}), (Terms{{43, Side::Both, 100}}));
}

TEST(Blender, GroupsReadWhatTheGroupBeforeThemLeft) {
  // The alternative removes 43, so that nothing excludes 5 any more.
  RuleSet rules{
      "two", false, {rule(RuleKind::Exclusion, {43}, {5}), rule(RuleKind::Alternative, {26, 43})}};
  EXPECT_EQ(blended_set(rules, {5, 26, 43}), (Terms{{5, Side::Both, 100}, {26, Side::Both, 100}}));
  rules.all_read_input = true;
  EXPECT_EQ(blended_set(rules, {5, 26, 43}), (Terms{{26, Side::Both, 100}}));
}

TEST(Blender, TheOrderOfRulesDoesNotMatter) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::mt19937_64 engine(seeded.seed());
  for (const auto* name : {"facs", "kumar2010"}) {
    const RuleSet rules = profile(name);
    const std::vector<int> numbers = numbers_in(rules);
    for (int run = 0; run < 200; ++run) {
      RuleSet shuffled = rules;
      std::shuffle(shuffled.rules.begin(), shuffled.rules.end(), engine);
      const AuFrame frame = random_frame(seeded, numbers);
      ASSERT_EQ(blend(shuffled, frame), blend(rules, frame)) << name << ", run " << run;
    }
  }
}

TEST(Blender, ResultsStayIntensitiesAndOnlySubstitutionAdds) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const RuleSet rules = profile("facs");
  const std::vector<int> numbers = numbers_in(rules);
  for (int run = 0; run < 500; ++run) {
    const AuFrame frame = random_frame(seeded, numbers);
    const AuFrame result = blend(rules, frame);
    for (std::size_t i = 0; i < result.left.size(); ++i) {
      ASSERT_GE(result.left[i], 0.0F);
      ASSERT_LE(result.left[i], 1.0F);
      if (i != 12) {
        ASSERT_LE(result.left[i], frame.left[i]) << "AU" << i;
        ASSERT_LE(result.right[i], frame.right[i]) << "AU" << i;
      }
    }
  }
}

TEST(Blender, BlendingTwiceChangesNothingWhereOnceIsEnough) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  Rule capped = rule(RuleKind::Cap, {5}, {7});
  capped.cap = 0.5F;
  const std::vector<RuleSet> idempotent = {
      one(rule(RuleKind::Alternative, {5, 7})), one(rule(RuleKind::Opposition, {5, 7})),
      one(capped), one(rule(RuleKind::Substitution, {5, 7}, {9})), profile("none")};
  for (const RuleSet& rules : idempotent) {
    for (int run = 0; run < 200; ++run) {
      const AuFrame once = blend(rules, random_frame(seeded, {5, 7, 9}));
      ASSERT_EQ(blend(rules, once), once);
    }
  }
  // At full intensity facs as a whole is idempotent too.
  const RuleSet facs = profile("facs");
  const std::vector<int> numbers = numbers_in(facs);
  for (int run = 0; run < 300; ++run) {
    std::vector<int> present;
    for (const int number : numbers) {
      if (seeded.chance(0.3)) present.push_back(number);
    }
    const AuFrame once = blend(facs, set_of(present));
    ASSERT_EQ(blend(facs, once), once);
  }
}

TEST(Blender, TellsWhichRuleDidWhat) {
  const RuleSet rules = profile("facs");
  std::vector<RuleFired> fired;
  static_cast<void>(blend(
      rules,
      frame_from_terms(Terms{
          {51, Side::Both, 100}, {52, Side::Both, 40}, {13, Side::Left, 50}, {14, Side::Left, 50}}),
      &fired));
  EXPECT_EQ(fired.size(), 3U) << "a side by itself";
  std::vector<RuleExplained> explained = explain(fired);
  ASSERT_EQ(explained.size(), 2U);
  std::sort(explained.begin(), explained.end(),
            [](const auto& a, const auto& b) { return a.before[0].number > b.before[0].number; });
  EXPECT_EQ(explained[0].before, (std::vector<AuShare>{{51, 100}, {52, 40}}));
  EXPECT_EQ(explained[0].after, (std::vector<AuShare>{{51, 60}, {52, 0}})) << "0: gone";
  EXPECT_EQ(explained[0].side, Side::Both);
  EXPECT_EQ(explained[0].rule->kind, RuleKind::Opposition);
  EXPECT_NE(explained[0].rule->source.find("FACS 2002"), std::string::npos);
  EXPECT_EQ(explained[1].before, (std::vector<AuShare>{{13, 50}, {14, 50}}));
  EXPECT_EQ(explained[1].after, (std::vector<AuShare>{{12, 50}, {13, 0}, {14, 0}}));
  EXPECT_EQ(explained[1].side, Side::Left);
}

TEST(Blender, ExplainsASideByItselfWhereBothDiffer) {
  const RuleSet rules = one(rule(RuleKind::Opposition, {51, 52}));
  std::vector<RuleFired> fired;
  static_cast<void>(blend(
      rules,
      frame_from_terms(Terms{{51, Side::Both, 100}, {52, Side::Left, 40}, {52, Side::Right, 30}}),
      &fired));
  const std::vector<RuleExplained> explained = explain(fired);
  ASSERT_EQ(explained.size(), 2U);
  EXPECT_EQ(explained[0].side, Side::Left);
  EXPECT_EQ(explained[1].side, Side::Right);
  EXPECT_EQ(explained[1].after, (std::vector<AuShare>{{51, 70}, {52, 0}}));
}

TEST(Blender, AllocatesNothing) {
  const RuleSet rules = profile("facs");
  std::vector<RuleFired> fired;
  fired.reserve(2 * rules.rules.size());
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 100; ++run) {
    const AuFrame frame = random_frame(seeded, {1, 4, 5, 7, 9, 12, 13, 14, 23, 26, 51, 52});
    fired.clear();
    const std::size_t before = aucast::test::allocations();
    static_cast<void>(blend(rules, frame, &fired));
    ASSERT_EQ(aucast::test::allocations(), before);
  }
  EXPECT_FALSE(fired.empty());
}

TEST(Blender, TellsNothingWhenNothingChanges) {
  std::vector<RuleFired> fired;
  static_cast<void>(blend(profile("facs"), set_of({1, 2, 5, 26}), &fired));
  EXPECT_TRUE(fired.empty());
}

}  // namespace
}  // namespace aucast::face
