#pragma once

#include <cstdint>
#include <optional>

#include "protocol/codec.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// A live stream whose keyframes are made elsewhere and come one by one: each is the newest moment
/// as soon as it comes.
/// Thread: none of its own.
class LiveFeed final : public LiveChannel {
 public:
  /// `classic_min` as in encode_classic(). `voice`, `captions`: these may come.
  /// `duration_ms`: of the whole stream, if it is known.
  LiveFeed(std::uint32_t keyframe_ms, int classic_min, bool voice = false, bool captions = false,
           std::optional<std::uint64_t> duration_ms = std::nullopt);

  /// What is added from here to the next call came together: latest() has all of it. Without any
  /// call each comes alone.
  void begin_moments() {
    together_ = true;
    moments_told_ = true;
  }
  /// The next moment, a full keyframe. A stream that had ended goes on.
  void add(const Keyframe& keyframe);
  /// The same, already encoded, for relays, which pass packets on.
  void add(EncodedKeyframe encoded, Milliseconds time);
  /// Where the newest moment ends on the channel's clock: the place of the instant at which its
  /// keyframe was made, and so of the sound of that instant.
  [[nodiscard]] Milliseconds end_of_newest() const { return end_; }
  /// Adds the next packet of the voice; it is left out if its place is before the end of the
  /// previous one. Without effect when the feed has no voice.
  void add_voice(const VoicePacket& packet) { add_voice(EncodedVoice(packet)); }
  void add_voice(EncodedVoice voice);
  void add_caption(CaptionData caption);
  /// Nothing more comes for now: the clients get {-2}.
  void end() { ended_ = true; }

 private:
  std::uint32_t keyframe_ms_;
  KeyframeEncoder encoder_;
  bool together_ = false;
  bool moments_told_ = false;  ///< those that are there, before what comes together now
  Milliseconds end_{0};        ///< of the newest moment
  double usual_ms_ = 33;       ///< between two moments, lately
};

}  // namespace aucast::protocol
