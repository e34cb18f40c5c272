#include "protocol/encoded_track.h"

#include "common/check.h"
#include "protocol/codec.h"

namespace aucast::protocol {

EncodedVoice::EncodedVoice(const VoicePacket& packet)
    : begin(packet.place),
      end(packet.place + opus_duration(packet.opus).value_or(Milliseconds{0})),
      continued(encode(VoiceData{std::nullopt, packet.opus})) {}

void EncodedTrack::add(const VoicePacket& packet) {
  AUCAST_CHECK(packets_.empty() || packet.place >= packets_.back().end);
  packets_.emplace_back(packet);
  bytes_ += packets_.back().continued.size();
  encoded_to(packets_.back().end);
}

bool same_spoken(const std::shared_ptr<const SpokenTrack>& one,
                 const std::shared_ptr<const SpokenTrack>& other) {
  if (one == nullptr || other == nullptr) return one == other;
  return one->voice == other->voice && one->captions == other->captions;
}

}  // namespace aucast::protocol
