#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/expressions/expressions.h"
#include "common/result.h"
#include "speaker/script.h"

namespace aucast::speaker {

/// Sets of AUs by name, as in data/expressions.toml; an empty one is of muscles alone, which no
/// stream carries.
using Expressions = std::map<std::string, std::vector<AuTerm>, std::less<>>;

/// The sets of these expressions.
[[nodiscard]] Expressions sets_of(const std::vector<Expression>& expressions);

/// The AUs that a cue asks for, which is a name of `expressions` or "smile", perhaps with a percent
/// after it ("smile 60"), or AUs, of which the first is a number ("6,12:60"). Fails with BadData,
/// and says what is wrong or what to write instead, but not where.
[[nodiscard]] Result<std::vector<AuTerm>> terms_of(std::string_view cue,
                                                   const Expressions& expressions);

/// Checks that every cue is known to terms_of(). Fails with BadData and file:line:column.
[[nodiscard]] Result<void> check_cues(const Script& script, const Expressions& expressions,
                                      std::string_view file);

}  // namespace aucast::speaker
