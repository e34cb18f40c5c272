#pragma once

#include <optional>

#include "client/playback/keyframe_source.h"

namespace aucast::playback::test {

/// A keyframe that can be told from others: `mark` stands in AU 1 of the left side.
inline Keyframe marked(int mark, std::optional<Milliseconds> time = std::nullopt) {
  Keyframe keyframe;
  keyframe.aus.left[1] = static_cast<float>(mark);
  keyframe.time = time;
  return keyframe;
}

[[nodiscard]] inline int mark_of(const Keyframe& keyframe) {
  return static_cast<int>(keyframe.aus.left[1]);
}

}  // namespace aucast::playback::test
