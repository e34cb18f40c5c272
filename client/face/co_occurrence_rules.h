#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::face {

/// How AUs influence each other. Alternative, substitution, dominance, additive and different are
/// FACS' (thesis 3.4.1; the last two change nothing and are there to be written down), exclusion
/// and opposition Wojdel's, cap and a substitution that keeps its sources our own. The formulas are
/// in au_blender.h.
enum class RuleKind : std::uint8_t {
  Opposition,
  Alternative,
  Exclusion,
  Cap,
  Substitution,
  Dominance,
  MultipleDominance,
  Additive,
  Different,
};

[[nodiscard]] std::string_view name(RuleKind kind);

/// One rule as data. Opposition, alternative, additive and different are among equals: they have
/// `sources` only, of which an alternative prefers the first on a tie.
struct Rule {
  RuleKind kind = RuleKind::Additive;
  std::vector<int> sources;   ///< the AUs that decide: dominant, excluding, replaced ones
  std::vector<int> targets;   ///< the AUs that change; substitution: the AU that appears
  float cap = 1;              ///< Cap: the most that a target keeps while a source is present
  bool keep_sources = false;  ///< Substitution: the replaced AUs stay ("9 implies 11")
  bool all_needed = false;    ///< MultipleDominance: all sources together (min), not any (max)
  std::string source;         ///< where it comes from, for --explain
};

/// A named set of rules.
struct RuleSet {
  std::string name;
  /// True: every rule reads the input (kumar2010). False: group by group in the order Opposition,
  /// Alternative, Exclusion, Cap, Substitution, Dominance; inside a group all read the values from
  /// before it.
  bool all_read_input = false;
  std::vector<Rule> rules;
};

/// Reads a rules file (TOML). BadData with file:line:column, also for an AU that FACS does not
/// name.
[[nodiscard]] Result<RuleSet> load_rules(const std::filesystem::path& file);

/// What --rules names: facs, kumar2010 (data/rules/NAME.toml), none, or a path. Usage error for a
/// name that is neither, with the nearest one.
[[nodiscard]] Result<RuleSet> find_rules(std::string_view choice,
                                         const std::filesystem::path& data_folder);

}  // namespace aucast::face
