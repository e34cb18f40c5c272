#pragma once

#include <vector>

#include "speaker/curves.h"
#include "speaker/speech.h"

namespace aucast::speaker {

/// Adds to the curves what the lips do while `phonemes` are heard, up to `end`; where a curve
/// already has a stronger intensity, that intensity is kept. The lips for a sound blend with those
/// for its neighbours by dominance (Cohen and Massaro 1993), which rises before the sound begins;
/// the lead times follow Edwards et al. 2016. Where the lips must meet, or touch the teeth, they do
/// so whatever the neighbours are.
void move_lips(const std::vector<Phoneme>& phonemes, Milliseconds end, Curves& curves);

}  // namespace aucast::speaker
