#include "client/face/co_occurrence_rules.h"

#include <algorithm>
#include <array>
#include <set>
#include <system_error>
#include <utility>

#include "common/text.h"
#include "common/toml_reader.h"

namespace aucast::face {
namespace {

constexpr std::size_t kRulesBytesMax = std::size_t{1} << 20U;
constexpr std::size_t kRulesMax = 1000;
constexpr std::array<std::string_view, 9> kKindNames = {
    "opposition", "alternative",        "exclusion", "cap",      "substitution",
    "dominance",  "multiple_dominance", "additive",  "different"};

/// Checks that FACS names every AU of a rule.
void check_named(TableReader& reader, std::string_view key, const std::vector<int>& numbers) {
  std::set<int> seen;
  for (const int number : numbers) {
    if (!facs_name(number)) {
      reader.wrong(key, "holds AU" + std::to_string(number) + ", which FACS does not name");
    }
    if (!seen.insert(number).second) {
      reader.wrong(key, "holds AU" + std::to_string(number) + " twice");
    }
  }
}

std::vector<int> read_aus(TableReader& reader, std::string_view key) {
  std::vector<int> numbers = reader.integers(key, 1, kAuNumberMax);
  check_named(reader, key, numbers);
  return numbers;
}

void check_count(TableReader& reader, std::string_view key, const std::vector<int>& numbers,
                 std::size_t low, std::size_t high, std::string_view count) {
  if (numbers.size() >= low && numbers.size() <= high) return;
  reader.wrong(key, "must name " + std::string(count));
}

/// Kinds whose AUs are equals have one list of AUs, all others sources and targets.
void read_lists(TableReader& reader, Rule& rule) {
  switch (rule.kind) {
    case RuleKind::Opposition:
      rule.sources = read_aus(reader, "aus");
      check_count(reader, "aus", rule.sources, 2, 2, "two AUs");
      return;
    case RuleKind::Alternative:
    case RuleKind::Additive:
    case RuleKind::Different:
      rule.sources = read_aus(reader, "aus");
      check_count(reader, "aus", rule.sources, 2, kAuCount, "two AUs or more");
      return;
    default:
      break;
  }
  rule.sources = read_aus(reader, "sources");
  rule.targets = read_aus(reader, "targets");
  for (const int target : rule.targets) {
    if (std::find(rule.sources.begin(), rule.sources.end(), target) == rule.sources.end()) continue;
    reader.wrong("targets", "holds AU" + std::to_string(target) + ", which is a source too");
  }
  if (rule.kind == RuleKind::Dominance) {
    check_count(reader, "sources", rule.sources, 1, 1,
                "one AU; for more there is multiple_dominance");
  } else if (rule.kind == RuleKind::MultipleDominance) {
    check_count(reader, "sources", rule.sources, 2, kAuCount, "two AUs or more");
    rule.all_needed = reader.boolean_or("all_needed", false);
  } else if (rule.kind == RuleKind::Substitution) {
    check_count(reader, "targets", rule.targets, 1, 1, "the one AU that appears");
    rule.keep_sources = reader.boolean_or("keep_sources", false);
  } else if (rule.kind == RuleKind::Cap) {
    rule.cap = reader.number("cap_percent", Bounds::between(0, 100)) / 100.0F;
  }
}

Rule read_rule(const TomlValue& table, Problems& problems) {
  TableReader reader(table, problems);
  Rule rule;
  const std::string kind = reader.text("kind");
  rule.source = reader.text_or("source", "");
  const auto* const found = std::find(kKindNames.begin(), kKindNames.end(), kind);
  if (found == kKindNames.end()) {
    reader.wrong("kind", "'" + escaped(kind) + "' is unknown" +
                             did_you_mean(kind, {kKindNames.begin(), kKindNames.end()}));
    return rule;
  }
  rule.kind = static_cast<RuleKind>(found - kKindNames.begin());
  read_lists(reader, rule);
  reader.finish();
  return rule;
}

}  // namespace

std::string_view name(RuleKind kind) {
  return kKindNames[static_cast<std::size_t>(kind)];
}

Result<RuleSet> load_rules(const std::filesystem::path& file) {
  const auto document = read_toml(file, kRulesBytesMax);
  if (!document) return document.error();
  Problems problems(file.string());
  TableReader reader(*document, problems);
  static_cast<void>(reader.integer("format", 1, 1));
  RuleSet set;
  set.name = reader.text("name");
  set.all_read_input = reader.boolean_or("all_read_input", false);
  const auto tables = reader.tables("rule");
  if (tables.size() > kRulesMax) {
    reader.wrong("rule", "has more than " + std::to_string(kRulesMax) + " entries");
  }
  for (const TomlValue* table : tables) set.rules.push_back(read_rule(*table, problems));
  reader.finish();
  if (auto result = problems.result(); !result) return result.error();
  return set;
}

Result<RuleSet> find_rules(std::string_view choice, const std::filesystem::path& data_folder) {
  if (choice == "none") return RuleSet{"none", false, {}};
  if (choice == "facs" || choice == "kumar2010") {
    return load_rules(data_folder / "rules" / (std::string(choice) + ".toml"));
  }
  const std::filesystem::path file(choice);
  std::error_code error;
  const bool meant_as_file = choice.find('/') != std::string_view::npos ||
                             choice.ends_with(".toml") || std::filesystem::exists(file, error);
  if (meant_as_file) return load_rules(file);
  return Error{ErrorKind::Usage, "unknown rules '" + escaped(choice) +
                                     "' (known: facs, kumar2010, none, or a file)" +
                                     did_you_mean(choice, {"facs", "kumar2010", "none"})};
}

}  // namespace aucast::face
