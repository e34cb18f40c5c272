#include "client/face/co_occurrence_rules.h"

#include <gtest/gtest.h>

#include <ostream>

#include "tests/support/temp_folder.h"
#include "tests/unit/face/shipped_data.h"

namespace aucast::face {
namespace {

using aucast::test::TempFolder;
using test::kData;

TEST(Rules, BothProfilesLoadAndNameTheirSources) {
  for (const auto* choice : {"facs", "kumar2010"}) {
    const auto rules = find_rules(choice, kData);
    ASSERT_TRUE(rules.has_value()) << rules.error().message;
    EXPECT_EQ(rules->name, choice);
    EXPECT_FALSE(rules->rules.empty());
    for (const Rule& rule : rules->rules) EXPECT_FALSE(rule.source.empty());
  }
  EXPECT_TRUE(find_rules("kumar2010", kData)->all_read_input);
  EXPECT_FALSE(find_rules("facs", kData)->all_read_input);
}

TEST(Rules, NoneHasNone) {
  const auto rules = find_rules("none", "/nowhere");
  ASSERT_TRUE(rules.has_value());
  EXPECT_TRUE(rules->rules.empty());
}

TEST(Rules, AnUnknownNameIsAUsageErrorWithTheNearest) {
  const auto rules = find_rules("fasc", kData);
  ASSERT_FALSE(rules.has_value());
  EXPECT_EQ(rules.error().kind, ErrorKind::Usage);
  EXPECT_EQ(rules.error().message,
            "unknown rules 'fasc' (known: facs, kumar2010, none, or a file); did you mean facs?");
}

TEST(Rules, AMissingFileIsUnreadable) {
  for (const auto* choice : {"/nowhere/my.toml", "my_rules.toml"}) {
    const auto rules = find_rules(choice, kData);
    ASSERT_FALSE(rules.has_value());
    EXPECT_EQ(rules.error().kind, ErrorKind::Unreadable);
  }
}

TEST(Rules, EveryKindReadsItsOwnKeys) {
  const TempFolder folder;
  const auto file = folder.write("all.toml", R"(format = 1
name = "all"
rule = [
  { kind = "opposition", aus = [51, 52] },
  { kind = "alternative", aus = [43, 45, 46] },
  { kind = "exclusion", sources = [18], targets = [28] },
  { kind = "cap", sources = [5], targets = [7], cap_percent = 80 },
  { kind = "substitution", sources = [13, 14], targets = [12], keep_sources = true },
  { kind = "dominance", sources = [9], targets = [10, 7] },
  { kind = "multiple_dominance", sources = [1, 2], targets = [4], all_needed = true },
  { kind = "additive", aus = [1, 26] },
  { kind = "different", aus = [1, 4], source = "book" },
]
)");
  const auto set = find_rules(file.string(), kData);
  ASSERT_TRUE(set.has_value()) << set.error().message;
  ASSERT_EQ(set->rules.size(), 9U);
  EXPECT_EQ(set->rules[1].sources, (std::vector<int>{43, 45, 46}));
  EXPECT_FLOAT_EQ(set->rules[3].cap, 0.8F);
  EXPECT_TRUE(set->rules[4].keep_sources);
  EXPECT_EQ(set->rules[5].targets, (std::vector<int>{10, 7}));
  EXPECT_TRUE(set->rules[6].all_needed);
  EXPECT_EQ(set->rules[8].source, "book");
  for (std::size_t i = 0; i < set->rules.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(set->rules[i].kind), i) << name(set->rules[i].kind);
  }
}

struct BadRules {
  std::string text;
  std::string message;
};

void PrintTo(const BadRules& bad, std::ostream* out) {
  *out << bad.message;
}

class BadRulesFile : public ::testing::TestWithParam<BadRules> {};

TEST_P(BadRulesFile, IsRefusedWithPlaceAndCause) {
  const TempFolder folder;
  const auto file = folder.write("bad.toml", GetParam().text);
  const auto rules = load_rules(file);
  ASSERT_FALSE(rules.has_value());
  EXPECT_EQ(rules.error().kind, ErrorKind::BadData);
  EXPECT_EQ(rules.error().message, file.string() + GetParam().message);
}

std::string with(const std::string& rule) {
  return "format = 1\nname = \"x\"\n[[rule]]\n" + rule;
}

const std::vector<BadRules> kBadRules = {
    {"", ":1:1: 'format' is missing"},
    {"format = 2\nname = \"x\"\n", ":1:10: format is 2, must be from 1 to 1"},
    {"format = 1\n", ":1:1: 'name' is missing"},
    {"format = 1\nname = \"x\"\nrules = []\n", ":3:1: unknown key 'rules'; did you mean rule?"},
    {"format = 1\nname = \"x\"\nrule = 3\n", ":3:8: rule must be written [[rule]]"},
    {with("kind = \"dominence\"\n"), ":4:8: kind 'dominence' is unknown; did you mean dominance?"},
    {with("sources = [1]\n"), ":3:1: 'kind' is missing"},
    {with("kind = \"dominance\"\nsources = [9]\ntargets = [3]\n"),
     ":6:11: targets holds AU3, which FACS does not name"},
    {with("kind = \"dominance\"\nsources = [100]\ntargets = [3]\n"),
     ":5:12: sources must hold whole numbers from 1 to 99"},
    {with("kind = \"dominance\"\nsources = [0]\ntargets = [3]\n"),
     ":5:12: sources must hold whole numbers from 1 to 99"},
    {with("kind = \"dominance\"\nsources = [\"9\"]\ntargets = [3]\n"),
     ":5:12: sources must hold whole numbers from 1 to 99"},
    {with("kind = \"dominance\"\nsources = []\ntargets = [10]\n"),
     ":5:11: sources must not be empty"},
    {with("kind = \"dominance\"\nsources = [9]\n"), ":3:1: 'targets' is missing"},
    {with("kind = \"dominance\"\nsources = [9, 10]\ntargets = [7]\n"),
     ":5:11: sources must name one AU; for more there is multiple_dominance"},
    {with("kind = \"multiple_dominance\"\nsources = [9]\ntargets = [7]\n"),
     ":5:11: sources must name two AUs or more"},
    {with("kind = \"dominance\"\nsources = [9]\ntargets = [7, 9]\n"),
     ":6:11: targets holds AU9, which is a source too"},
    {with("kind = \"dominance\"\nsources = [9]\ntargets = [7, 7]\n"),
     ":6:11: targets holds AU7 twice"},
    {with("kind = \"dominance\"\nsources = [9]\ntargets = [7]\ncap_percent = 3\n"),
     ":7:1: unknown key 'cap_percent'"},
    {with("kind = \"opposition\"\naus = [51, 52, 53]\n"), ":5:7: aus must name two AUs"},
    {with("kind = \"alternative\"\naus = [51]\n"), ":5:7: aus must name two AUs or more"},
    {with("kind = \"opposition\"\nsources = [51]\ntargets = [52]\n"), ":3:1: 'aus' is missing"},
    {with("kind = \"substitution\"\nsources = [13]\ntargets = [12, 11]\n"),
     ":6:11: targets must name the one AU that appears"},
    {with("kind = \"cap\"\nsources = [5]\ntargets = [7]\n"), ":3:1: 'cap_percent' is missing"},
    {with("kind = \"cap\"\nsources = [5]\ntargets = [7]\ncap_percent = 180\n"),
     ":7:15: cap_percent is 180, must be from 0 to 100"},
    {with("kind = \"cap\"\nsources = [5]\ntargets = [7]\ncap_percent = nan\n"),
     ":7:15: cap_percent is not a finite number"},
};

INSTANTIATE_TEST_SUITE_P(All, BadRulesFile, ::testing::ValuesIn(kBadRules));

TEST(Rules, AsManyAsAreAllowedAreReadAndNoMore) {
  std::string text = "format = 1\nname = \"x\"\n";
  for (int i = 0; i < 1000; ++i) text += "[[rule]]\nkind = \"additive\"\naus = [1, 2]\n";
  const TempFolder folder;
  const auto most = load_rules(folder.write("most.toml", text));
  ASSERT_TRUE(most.has_value()) << most.error().message;
  EXPECT_EQ(most->rules.size(), 1000U);
  const auto more =
      load_rules(folder.write("more.toml", text + "[[rule]]\nkind = \"additive\"\naus = [1, 2]\n"));
  ASSERT_FALSE(more.has_value());
  EXPECT_EQ(more.error().kind, ErrorKind::BadData);
  EXPECT_NE(more.error().message.find("rule has more than 1000 entries"), std::string::npos)
      << more.error().message;
  const auto large = load_rules(folder.write("large.toml", std::string((1U << 20U) + 1, '#')));
  ASSERT_FALSE(large.has_value());
  EXPECT_EQ(large.error().kind, ErrorKind::Unreadable);
}

TEST(Rules, TextThatIsNoTomlIsRefusedWithPlace) {
  const TempFolder folder;
  const auto rules = load_rules(folder.write("bad.toml", "format = 1\nname = \n"));
  ASSERT_FALSE(rules.has_value());
  EXPECT_EQ(rules.error().kind, ErrorKind::BadData);
  EXPECT_NE(rules.error().message.find("bad.toml:2:8: "), std::string::npos)
      << rules.error().message;
}

}  // namespace
}  // namespace aucast::face
