#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::face {

/// How AUs influence each other; the formulas are in au_blender.h. Alternative, substitution,
/// dominance, additive and different come from FACS (thesis 3.4.1); additive and different change
/// nothing and only record what FACS says. Exclusion and opposition come from Wojdel. Cap is ours,
/// and so is a substitution that keeps its sources.
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

/// One rule as data. Opposition, alternative, additive and different have only `sources`, none of
/// which ranks above another; on a tie, an alternative prefers the first.
struct Rule {
  RuleKind kind = RuleKind::Additive;
  std::vector<int> sources;   ///< the AUs that decide: dominant, excluding, replaced ones
  std::vector<int> targets;   ///< the AUs that change; substitution: the AU that appears
  float cap = 1;              ///< Cap: the highest intensity of a target while a source is present
  bool keep_sources = false;  ///< Substitution: the replaced AUs stay ("9 implies 11")
  bool all_needed = false;    ///< MultipleDominance: true: all sources must be present, and the
                              ///< smallest counts; false: one is enough, and the largest counts
  std::string source;         ///< the publication or rule book that it is from; --explain shows it
};

/// A named set of rules.
struct RuleSet {
  std::string name;
  /// True: every rule reads the input (kumar2010). False: rules apply in groups, in the order
  /// Opposition, Alternative, Exclusion, Cap, Substitution, Dominance; the rules of a group read
  /// the values from before that group.
  bool all_read_input = false;
  std::vector<Rule> rules;
};

/// Reads a rules file (TOML). Fails with BadData and file:line:column if something in it is wrong,
/// such as an AU that FACS does not name.
[[nodiscard]] Result<RuleSet> load_rules(const std::filesystem::path& file);

/// The rules that --rules names: facs, kumar2010 (data/rules/NAME.toml), none, or a path. Anything
/// else is a Usage error, which suggests the nearest name.
[[nodiscard]] Result<RuleSet> find_rules(std::string_view choice,
                                         const std::filesystem::path& data_folder);

}  // namespace aucast::face
