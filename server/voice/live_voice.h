#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/time.h"
#include "common/voice/voice_encoder.h"
#include "protocol/voice_packet.h"
#include "server/voice/slow_line.h"

namespace aucast::server {

/// Encodes sound that comes together with a live face, as packets on the clock of the face's
/// stream. One SlowLine finds from the arriving samples when the sound began, another one from the
/// arriving keyframes when the face's clock began. If the two clocks drift apart, pauses in the
/// sound get longer or shorter.
/// Thread: none of its own.
class LiveVoice {
 public:
  /// `delay`: by how much the sound is played later, to match a face that is late.
  LiveVoice(const voice::VoiceSettings& settings, Milliseconds delay);

  /// A keyframe that ends at `end` on the stream's clock was made now.
  void add_keyframe(Milliseconds end, SteadyTime now);
  /// The stream has ended, and begins anew with the next keyframe.
  void end_face() { face_.forget(); }
  /// Takes samples, 16-bit signed little-endian, mono at kEncoderRate, and returns the packets that
  /// they complete. Samples before the first keyframe have no place and are dropped.
  [[nodiscard]] std::vector<protocol::VoicePacket> add(std::string_view bytes, SteadyTime now);
  /// The writer has gone: the next samples do not continue the last. Returns the packets of the
  /// samples that are left.
  [[nodiscard]] std::vector<protocol::VoicePacket> end_sound();

 private:
  [[nodiscard]] std::vector<float> samples_of(std::string_view bytes);
  [[nodiscard]] std::size_t steer(Milliseconds target, std::size_t count,
                                  std::vector<protocol::VoicePacket>& packets);

  voice::VoiceEncoder encoder_;
  Milliseconds delay_;
  SlowLine face_;
  SlowLine sound_;
  std::uint64_t samples_ = 0;  ///< how many came since sound_ began
  std::string half_;           ///< the first byte of a sample whose second byte has not come
  bool placed_ = false;        ///< the encoder's place is that of the sound
  Milliseconds silent_{0};     ///< how long there has been no packet
};

}  // namespace aucast::server
