#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "common/time.h"
#include "protocol/voice_packet.h"

struct OpusEncoder;

namespace aucast::voice {

/// Samples a second of the sound to be encoded: wideband speech, mono.
inline constexpr int kEncoderRate = 16000;
inline constexpr int kEncoderSamplesPerMs = kEncoderRate / 1000;

struct VoiceSettings {
  int bits_per_second = 10000;  ///< 6000-64000; below 8000 wideband speech falls apart
  Milliseconds frame{60};       ///< length of each packet: 20, 40 or 60
  friend bool operator==(const VoiceSettings&, const VoiceSettings&) = default;
};

/// Turns speech into Opus packets. The packet at a place decodes to the sound from that very place
/// on: the encoder compensates the codec's delay. Silence (-52 dBFS or less for 240 ms) makes no
/// packets, except at the end of the sound. The same samples and settings give the same packets,
/// however the samples are divided into calls.
/// Thread: none of its own.
class VoiceEncoder {
 public:
  /// The first sample lies at `begin` on the stream's clock.
  explicit VoiceEncoder(const VoiceSettings& settings, Milliseconds begin = Milliseconds{0});
  ~VoiceEncoder();
  VoiceEncoder(VoiceEncoder&&) noexcept;
  VoiceEncoder& operator=(VoiceEncoder&&) noexcept;

  /// Takes mono samples at kEncoderRate, in [-1,1], and appends the packets that they complete.
  void add(std::span<const float> samples, std::vector<protocol::VoicePacket>& packets);
  /// No more samples follow: appends the packets of the rest, filled up with silence. They end
  /// where the sound ended or less than a packet later.
  void finish(std::vector<protocol::VoicePacket>& packets);
  /// The next samples do not continue the last: they begin at `place`, later than all before.
  /// Samples that do not yet make a whole packet are dropped.
  void go_on_at(Milliseconds place);

  /// Where the sound added so far ends.
  [[nodiscard]] Milliseconds end() const;

 private:
  struct Destroy {
    void operator()(OpusEncoder* encoder) const;
  };

  void encode_frames(std::vector<protocol::VoicePacket>& packets);
  void encode_frame(std::span<const float> samples, std::vector<protocol::VoicePacket>& packets);

  std::unique_ptr<OpusEncoder, Destroy> encoder_;
  Milliseconds frame_;
  Milliseconds place_;          ///< of the next packet
  std::vector<float> pending_;  ///< samples from place_ on
  std::size_t lookahead_ = 0;   ///< the codec's delay in samples
  std::size_t skipped_ = 0;     ///< how many samples were left out at the beginning
  Milliseconds silent_{0};      ///< how long there has been no sound
};

}  // namespace aucast::voice
