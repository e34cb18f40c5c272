#include "protocol/encoded_stream.h"

#include <numeric>
#include <utility>

#include "common/check.h"
#include "protocol/limits.h"

namespace aucast::protocol {

Keyframe keyframe_of(std::string_view packet) {
  Keyframe keyframe;
  const auto error =
      parse_keyframe(packet.substr(1, packet.size() - 2), TermSyntax::Wire, keyframe);
  AUCAST_CHECK(!error);
  return keyframe;
}

Milliseconds length_of(const EncodedStream& stream) {
  return std::accumulate(stream.times.begin(), stream.times.end(), Milliseconds{0});
}

std::size_t held_bytes(const EncodedStream& stream) {
  const auto held = [](const PacketList& list) {
    return list.bytes() + list.size() * sizeof(std::uint32_t);
  };
  return held(stream.classic) + held(stream.negotiated) + held(stream.changes) +
         stream.times.size() * sizeof(KeyframeTime);
}

Entry entry_at(const EncodedStream& stream, std::uint64_t from_ms, bool loop) {
  // Most clients begin at 0; all keyframes are added up only if nobody knows what they come to.
  if (loop && from_ms > 0) {
    const std::uint64_t turn = stream.duration_ms
                                   ? *stream.duration_ms
                                   : static_cast<std::uint64_t>(length_of(stream).count());
    from_ms = turn == 0 ? 0 : from_ms % turn;
  }
  Entry entry;
  for (const KeyframeTime time : stream.times) {
    const std::uint64_t end_ms = entry.begin_ms + time.count();
    if (entry.begin_ms >= from_ms || end_ms > from_ms) break;
    entry.begin_ms = end_ms;
    ++entry.keyframe;
  }
  return entry;
}

void StreamEncoder::add(const Keyframe& keyframe) {
  const EncodedKeyframe encoded = encoder_.next(keyframe);
  stream_.classic.push_back(encoded.classic);
  stream_.negotiated.push_back(encoded.full);
  stream_.changes.push_back(encoded.changes);
  stream_.times.emplace_back(keyframe.time_ms.value_or(keyframe_ms_));
  duration_ms_ += stream_.times.back().count();
  plain_ = plain_ && encoded.plain;
}

EncodedStream StreamEncoder::finish() {
  if (plain_) stream_.changes = {};
  stream_.duration_ms = duration_ms_;
  return std::move(stream_);
}

EncodedStream encode_stream(std::span<const Keyframe> keyframes, std::uint32_t keyframe_ms,
                            int classic_min, const StopToken& stop) {
  StreamEncoder encoder(keyframe_ms, classic_min);
  for (const Keyframe& keyframe : keyframes) {
    if (stop.stop_requested()) break;
    encoder.add(keyframe);
  }
  return encoder.finish();
}

std::optional<Milliseconds> classic_length(const EncodedStream& stream) {
  if (stream.extent != Extent::Whole) return std::nullopt;
  const Milliseconds length = kDefaultKeyframeTime * stream.classic.size();
  const auto own = static_cast<std::uint64_t>(length.count());
  return stream.duration_ms.value_or(own) == own ? std::nullopt : std::optional(length);
}

}  // namespace aucast::protocol
