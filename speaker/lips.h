#pragma once

#include <vector>

#include "speaker/curves.h"
#include "speaker/speech.h"

namespace aucast::speaker {

/// Puts what the lips do while `phonemes` are heard onto the curves, strongest wins where something
/// is there already. Each sound's lips blend with its neighbours' by dominance, which rises before
/// the sound begins (Cohen and Massaro 1993; leads after Edwards et al. 2016); where the lips must
/// meet or touch the teeth they do, whatever the neighbours want.
void move_lips(const std::vector<Phoneme>& phonemes, Milliseconds end, Curves& curves);

}  // namespace aucast::speaker
