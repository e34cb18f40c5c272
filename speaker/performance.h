#pragma once

#include <vector>

#include "protocol/stream_file.h"
#include "speaker/cues.h"
#include "speaker/curves.h"
#include "speaker/gestures.h"
#include "speaker/script.h"
#include "speaker/speech.h"

namespace aucast::speaker {

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
