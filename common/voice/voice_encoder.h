#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "common/time.h"
#include "protocol/voice_packet.h"

struct OpusEncoder;

namespace aucast::voice {

/// Samples a second of what is encoded: mono, wideband speech.
inline constexpr int kEncoderRate = 16000;
inline constexpr int kEncoderSamplesPerMs = kEncoderRate / 1000;

struct VoiceSettings {
  int bits_per_second = 10000;  ///< 6000-64000; below 8000 wideband speech falls apart
  Milliseconds frame{60};       ///< 20, 40 or 60: of each packet
  friend bool operator==(const VoiceSettings&, const VoiceSettings&) = default;
};

/// Speech to Opus packets. The packet at a place decodes to the sound from that very place on: the
/// codec's delay is compensated here. Silence makes no packets (-52 dBFS or less for 240 ms), but
/// the end of the sound does. The same samples and settings give the same packets, however they are
/// cut.
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
  /// No more samples: appends the packets of the rest, filled up with silence, so that what decodes
  /// ends where the sound did or less than a packet later.
  void finish(std::vector<protocol::VoicePacket>& packets);
  /// What comes next does not continue what came: it begins at `place`, later than all before.
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
  std::vector<float> pending_;  ///< from that place on
  std::size_t lookahead_ = 0;   ///< samples that the codec is late by
  std::size_t skipped_ = 0;     ///< of those, at the beginning
  Milliseconds silent_{0};      ///< how long there has been no sound
};

}  // namespace aucast::voice
