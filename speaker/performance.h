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

/// Named sets of AUs, as in data/expressions.toml.
using Expressions = std::map<std::string, std::vector<AuTerm>, std::less<>>;

/// Those of the file, without what is made of muscles alone.
[[nodiscard]] Expressions sets_of(const std::vector<Expression>& expressions);

/// Whether every cue means something: a name of `expressions` or "smile", with a percent after it
/// if need be ("smile 60"), or AUs as in a packet ("6,12:60"). BadData with file:line:column.
[[nodiscard]] Result<void> check_cues(const Script& script, const Expressions& expressions,
                                      std::string_view file);

/// A face that speaks: lips, gestures, and the expressions of the script's cues from the word that
/// follows each until the next one or the end of its paragraph. check_cues() must have passed.
[[nodiscard]] protocol::StreamFile perform(const Speech& speech, const Script& script,
                                           const Expressions& expressions,
                                           const GestureOptions& options);

/// Keyframes between which straight lines stay within `tolerance` (an intensity) of the curves.
[[nodiscard]] std::vector<protocol::Keyframe> keyframes_of(const Curves& curves, float tolerance);

}  // namespace aucast::speaker
