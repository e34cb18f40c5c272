#include "protocol/packet_writer.h"

#include <algorithm>

#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {

SentCounts& SentCounts::operator+=(const SentCounts& other) {
  keyframes += other.keyframes;
  payload_bytes += other.payload_bytes;
  keyframes_merged += other.keyframes_merged;
  voice_packets += other.voice_packets;
  voice_left_out += other.voice_left_out;
  spoken_bytes += other.spoken_bytes;
  return *this;
}

void PacketWriter::write_keyframe(std::string_view packet, std::string& out) {
  out += packet;
  ++counts_.keyframes;
  counts_.payload_bytes += packet.size();
}

void PacketWriter::write_voice(const EncodedVoice& voice, Milliseconds shift, std::string& out) {
  const Milliseconds begin = voice.begin + shift;
  if (begin < voice_end_.value_or(Milliseconds{0})) return count_left_out(1);
  const std::size_t before = out.size();
  constexpr std::string_view kOpening = "{a";
  out += kOpening;
  if (begin != voice_end_) out.append("@").append(std::to_string(begin.count()));
  out.append(voice.continued, kOpening.size());
  voice_end_ = voice.end + shift;
  ++counts_.voice_packets;
  counts_.spoken_bytes += out.size() - before;
}

void PacketWriter::write_caption(const CaptionData& caption, Milliseconds shift, std::string& out) {
  // The caption that stands where a live client goes on began before that.
  last_caption_ = std::max(Milliseconds(caption.place_ms) + shift, last_caption_);
  const std::string packet =
      encode(CaptionData{static_cast<std::uint64_t>(last_caption_.count()), caption.text});
  // Another server's may have been so long that it only fitted with its place there.
  if (packet.size() > kCaptionBytesMax) return;
  counts_.spoken_bytes += packet.size();
  out += packet;
}

}  // namespace aucast::protocol
