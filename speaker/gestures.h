#pragma once

#include <cstdint>
#include <vector>

#include "speaker/curves.h"
#include "speaker/script.h"
#include "speaker/speech.h"

namespace aucast::speaker {

struct GestureOptions {
  std::uint64_t seed = 1;
  float amount = 1;  ///< of brows and head, 0-2; blinks always come
};

/// Puts what a speaker does beside speaking onto the curves: blinks (after sentences, and every few
/// seconds), raised brows and nods on stressed words, brows up at the end of a question, the head
/// that turns a little from phrase to phrase, a glance aside in a pause. The same speech, script
/// and options give the same movements.
void add_gestures(const Speech& speech, const Script& script, const GestureOptions& options,
                  Curves& curves);

/// Which words carry stress: long enough, and louder than their neighbours.
[[nodiscard]] std::vector<bool> stressed_words(const Speech& speech);

}  // namespace aucast::speaker
