#pragma once

#include <cstdint>

#include "protocol/codec.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// A live stream whose keyframes are made elsewhere and come one by one: each is the newest moment
/// as soon as it is there.
/// Thread: none of its own.
class LiveFeed final : public LiveChannel {
 public:
  /// `classic_min` as in encode_classic().
  LiveFeed(std::uint32_t keyframe_ms, int classic_min);

  /// The next moment, a full keyframe. A stream that had ended goes on.
  void add(const Keyframe& keyframe);
  /// Nothing more comes for now: who is there gets {-2}.
  void end() { ended_ = true; }

 private:
  std::uint32_t keyframe_ms_;
  KeyframeEncoder encoder_;
  double usual_ms_ = 33;  ///< between two moments, lately
};

}  // namespace aucast::protocol
