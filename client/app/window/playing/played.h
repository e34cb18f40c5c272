#pragma once

#include <cstddef>
#include <cstdint>

#include "client/playback/keyframe_list.h"
#include "protocol/limits.h"

namespace aucast::app {

/// What has been played from the beginning on, for exports.
struct Played {
  /// Of a stream that may never end only so many are kept, the first: an hour at 25 a second.
  static constexpr std::size_t kKept = 90'000;

  playback::KeyframeList keyframes;
  std::uint64_t begun = 0;  ///< how many keyframes have begun, kept or not
  Milliseconds untimed = protocol::kDefaultKeyframeTime;  ///< how long those without a time of
                                                          ///< their own were played

  /// Adds a keyframe of a stream that may never end.
  void add(const playback::Keyframe& keyframe) {
    ++begun;
    if (keyframes.size() < kKept) keyframes.push_back(keyframe);
  }
};

}  // namespace aucast::app
