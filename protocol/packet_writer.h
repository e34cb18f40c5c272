#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/time.h"
#include "protocol/encoded_track.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// Counts what one client was sent.
struct SentCounts {
  std::uint64_t keyframes = 0;
  std::uint64_t payload_bytes = 0;  ///< of the keyframes alone, as table 5.5 of the thesis counts
  /// Keyframes of a live stream that were left out, since the client was too slow for them.
  std::uint64_t keyframes_merged = 0;
  std::uint64_t voice_packets = 0;
  /// Left out with such keyframes, or since they would begin before the end of the last one.
  std::uint64_t voice_left_out = 0;
  std::uint64_t spoken_bytes = 0;  ///< of voice packets and captions

  SentCounts& operator+=(const SentCounts& other);
};

/// Writes packets for one client and counts them. Gives voice and captions their places on the
/// client's clock: `shift` is what to add to a place on their own clock. Thread: none of its own.
class PacketWriter {
 public:
  void write_keyframe(std::string_view packet, std::string& out);
  /// Writes {a DATA} if the voice begins where the last packet ended, else {a@PLACE DATA}. Leaves
  /// it out if it would begin before the end of the last one, or before 0.
  void write_voice(const EncodedVoice& voice, Milliseconds shift, std::string& out);
  /// Writes it with the place of the last one if its own is before that.
  void write_caption(const CaptionData& caption, Milliseconds shift, std::string& out);
  void count_merged(std::uint64_t keyframes) { counts_.keyframes_merged += keyframes; }
  void count_left_out(std::uint64_t voice_packets) { counts_.voice_left_out += voice_packets; }

  [[nodiscard]] const SentCounts& counts() const { return counts_; }

 private:
  SentCounts counts_;
  std::optional<Milliseconds> voice_end_;  ///< of the last voice packet
  Milliseconds last_caption_{0};           ///< place of the last caption
};

}  // namespace aucast::protocol
