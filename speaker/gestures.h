#pragma once

#include <cstdint>
#include <vector>

#include "speaker/curves.h"
#include "speaker/script.h"
#include "speaker/speech.h"

namespace aucast::speaker {

struct GestureOptions {
  std::uint64_t seed = 1;
  float amount = 1;  ///< factor on the movements of brows and head, 0-2; not on blinks
};

/// Adds to the curves what a speaker does besides moving the lips: blinks (after clauses, and
/// every few seconds), nods and raised or gathered brows on stressed words, raised brows at the end
/// of a question, small turns of the head and another bearing from phrase to phrase (raised brows,
/// a smile, gathered brows), a glance aside in a pause. Otherwise the eyes stay on the listeners
/// while the head moves. The same speech, script and options give the same movements.
void add_gestures(const Speech& speech, const Script& script, const GestureOptions& options,
                  Curves& curves);

/// For each word, whether it is stressed: long enough, and louder than its neighbours.
[[nodiscard]] std::vector<bool> stressed_words(const Speech& speech);

}  // namespace aucast::speaker
