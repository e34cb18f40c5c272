#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/action_unit.h"
#include "common/expressions/expressions.h"
#include "common/result.h"
#include "protocol/stream_file.h"
#include "speaker/curves.h"
#include "speaker/gestures.h"
#include "speaker/script.h"
#include "speaker/speech.h"

namespace aucast::speaker {

/// Sets of AUs by name, as in data/expressions.toml; an empty one is of muscles alone, which no
/// stream carries.
using Expressions = std::map<std::string, std::vector<AuTerm>, std::less<>>;

/// The sets of these expressions.
[[nodiscard]] Expressions sets_of(const std::vector<Expression>& expressions);

/// Checks that every cue is known: a name of `expressions` or "smile", perhaps with a percent after
/// it ("smile 60"), or AUs as in a packet ("6,12:60"). Fails with BadData and file:line:column, and
/// says what to write instead.
[[nodiscard]] Result<void> check_cues(const Script& script, const Expressions& expressions,
                                      std::string_view file);

/// Makes the stream of a face that speaks: lips, gestures, and the expressions that the script's
/// cues ask for. An expression begins with the word after its cue and lasts until the next cue or
/// the end of the paragraph. check_cues() must have passed.
[[nodiscard]] protocol::StreamFile perform(const Speech& speech, const Script& script,
                                           const Expressions& expressions,
                                           const GestureOptions& options);

/// Turns curves into keyframes. Straight lines between these differ from the curves by at most
/// `tolerance`, an intensity.
[[nodiscard]] std::vector<protocol::Keyframe> keyframes_of(const Curves& curves, float tolerance);

}  // namespace aucast::speaker
