#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "common/time.h"
#include "protocol/limits.h"
#include "protocol/live_feed.h"
#include "protocol/live_replay.h"
#include "server/streams/live_thinning.h"

namespace aucast::server {

struct ReplayLimits {
  LinkLimits link;
  std::uint32_t keyframe_ms =
      protocol::kDefaultKeyframeTime.count();  ///< time of an untimed keyframe
  int classic_min = 20;                        ///< percent, as in encode_classic()
};

/// A recorded stream that is sent live. With a voice and a limit on the link, its keyframes are
/// thinned as they are sent, since the room that the voice leaves for them changes all the time.
/// Thread: none of its own.
class ServedReplay {
 public:
  /// The arguments are those of protocol::LiveReplay, and the limits.
  ServedReplay(std::shared_ptr<const protocol::EncodedStream> stream, bool loop, Instant begin,
               std::shared_ptr<const protocol::SpokenTrack> spoken, const ReplayLimits& limits);

  /// Like LiveReplay::advance(); also true when a keyframe that had to wait was sent.
  bool advance(Instant now);
  [[nodiscard]] std::optional<Instant> next_at() const;
  [[nodiscard]] const protocol::LiveReplay& replay() const { return replay_; }
  /// The channel that clients are sent.
  [[nodiscard]] const protocol::LiveChannel& channel() const;

 private:
  void take_spoken(SteadyTime now);
  void take_moments();

  protocol::LiveReplay replay_;
  std::optional<protocol::LiveFeed> feed_;  ///< nullopt: the replay is sent as it is
  LiveThinning thinning_;
  std::uint64_t next_voice_ = 0;
  std::uint64_t next_caption_ = 0;
  std::uint64_t next_moment_ = 0;
};

}  // namespace aucast::server
