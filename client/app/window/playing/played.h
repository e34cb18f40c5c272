#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "client/playback/keyframe_source.h"

namespace aucast::app {

/// What has been played, from its beginning, as it is exported.
struct Played {
  /// An hour of a live stream at 25 a second.
  static constexpr std::size_t kKept = 90'000;

  std::vector<playback::Keyframe> keyframes;
  std::uint64_t begun = 0;  ///< so many there were: more than `keyframes` if not all were kept

  /// Of a stream that may never end.
  void add(playback::Keyframe keyframe) {
    ++begun;
    if (keyframes.size() < kKept) keyframes.push_back(std::move(keyframe));
  }
};

}  // namespace aucast::app
