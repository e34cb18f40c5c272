#pragma once

#include <cstdint>
#include <optional>

#include "protocol/codec.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// A live stream whose keyframes come one by one from a running source; each becomes the newest
/// moment at once.
/// Thread: none of its own.
class LiveFeed final : public LiveChannel {
 public:
  /// `classic_min`: the `percent_min` of encode_classic(). `voice`, `captions`: whether these may
  /// come. `duration_ms`: the length of the whole stream; nullopt: unknown.
  LiveFeed(std::uint32_t keyframe_ms, int classic_min, bool voice = false, bool captions = false,
           std::optional<std::uint64_t> duration_ms = std::nullopt);

  /// Call it before adding keyframes that have come together: latest() then has all of them. If it
  /// is never called, latest() has only the newest one.
  void begin_moments() {
    together_ = true;
    moments_told_ = true;
  }
  /// Adds the next moment, a full keyframe. A stream that had ended goes on.
  void add(const Keyframe& keyframe);
  /// The same with a keyframe that is already encoded, for relays, which pass packets on.
  void add(EncodedKeyframe encoded, Milliseconds time);
  /// Where the newest moment ends on the channel's clock. That is the place of its keyframe, and so
  /// of the sound that was recorded together with the keyframe.
  [[nodiscard]] Milliseconds end_of_newest() const { return end_; }
  /// Adds the next packet of the voice; it is left out if its place is before the end of the
  /// previous one. Without effect when the feed has no voice.
  void add_voice(const VoicePacket& packet) { add_voice(EncodedVoice(packet)); }
  void add_voice(EncodedVoice voice);
  void add_caption(CaptionData caption);
  /// Ends the stream, at least for now: the clients get {-2}.
  void end() { ended_ = true; }

 private:
  std::uint32_t keyframe_ms_;
  KeyframeEncoder encoder_;
  bool together_ = false;
  bool moments_told_ = false;  ///< the next add() replaces the moments in latest()
  Milliseconds end_{0};        ///< of the newest moment
  double usual_ms_ = 33;       ///< recent mean time between two moments
};

}  // namespace aucast::protocol
