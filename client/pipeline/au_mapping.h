#pragma once

#include <span>
#include <vector>

#include "client/face/au_blender.h"
#include "client/face/face.h"
#include "client/face/muscle_mixer.h"

namespace aucast::pipeline {

/// How Action Units become activations of one face: its recordings, the co-occurrence rules and the
/// mixer. The face must outlive it; the rest may change between two calls.
struct AuMapping {
  const face::Face& face;
  face::AuRecordings recordings;
  face::RuleSet rules;
  face::Mixer mixer = face::Mixer::Maximum;

  /// Blends, then mixes into `activations` (one per channel), and returns the AUs after the rules.
  /// The rules that changed something are appended to `fired`.
  AuFrame apply(const AuFrame& aus, std::span<float> activations,
                std::vector<face::RuleFired>* fired = nullptr) const {
    const AuFrame blended = face::blend(rules, aus, fired);
    face::mix(face.channels, recordings, blended, mixer, activations);
    return blended;
  }
};

}  // namespace aucast::pipeline
