#include "protocol/encoded_stream.h"

#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {

EncodedStream encode_stream(std::span<const Keyframe> keyframes, std::uint32_t keyframe_ms,
                            int classic_min) {
  EncodedStream stream;
  KeyframeEncoder encoder(keyframe_ms, classic_min);
  std::uint64_t whole_ms = 0;
  bool plain = true;
  for (const Keyframe& keyframe : keyframes) {
    const EncodedKeyframe encoded = encoder.next(keyframe);
    stream.classic.push_back(encoded.classic);
    stream.negotiated.push_back(encoded.full);
    stream.changes.push_back(encoded.changes);
    stream.times.emplace_back(keyframe.duration_ms.value_or(keyframe_ms));
    whole_ms += stream.times.back().count();
    plain = plain && encoded.plain;
  }
  if (plain) stream.changes = {};
  stream.duration_ms = whole_ms;
  return stream;
}

std::optional<Milliseconds> classic_length(const EncodedStream& stream) {
  const Milliseconds length = kDefaultKeyframeTime * stream.classic.size();
  const auto own = static_cast<std::uint64_t>(length.count());
  return stream.duration_ms.value_or(own) == own ? std::nullopt : std::optional(length);
}

}  // namespace aucast::protocol
