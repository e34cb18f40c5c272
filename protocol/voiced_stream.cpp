#include "protocol/voiced_stream.h"

#include <algorithm>
#include <string_view>

#include "common/check.h"
#include "protocol/codec.h"

namespace aucast::protocol {
namespace {

/// Encodes keyframes of any time in pieces.
class Cutter {
 public:
  Cutter(std::uint32_t keyframe_ms, int classic_min) : encoder_(keyframe_ms, classic_min) {}

  void add(const Keyframe& keyframe, KeyframeTime time) {
    const AuFrame to = frame_from_terms(keyframe.terms);
    const std::uint32_t longest = static_cast<std::uint32_t>(kVoicedKeyframeMax.count());
    const std::uint32_t pieces = std::max((time.count() + longest - 1) / longest, 1U);
    if (pieces == 1) {
      encoder_.add(keyframe);
    } else {
      for (std::uint32_t piece = 1; piece <= pieces; ++piece) {
        add_piece(keyframe, between(from_, to, static_cast<double>(piece) / pieces), time, piece,
                  pieces);
      }
    }
    from_ = to;
  }

  [[nodiscard]] EncodedStream finish() { return encoder_.finish(); }

 private:
  void add_piece(const Keyframe& whole, const AuFrame& aus, KeyframeTime time, std::uint32_t piece,
                 std::uint32_t pieces) {
    const std::uint64_t begin = std::uint64_t{time.count()} * (piece - 1) / pieces;
    const std::uint64_t end = std::uint64_t{time.count()} * piece / pieces;
    Keyframe part;
    part.terms = canonical_terms(aus);
    part.time_ms = static_cast<std::uint32_t>(end - begin);
    const std::uint64_t left = time.count() - end;
    if (whole.place_ms && *whole.place_ms >= left) part.place_ms = *whole.place_ms - left;
    encoder_.add(part);
  }

  StreamEncoder encoder_;
  AuFrame from_;
};

}  // namespace

std::shared_ptr<const EncodedStream> voiced_stream(const EncodedStream& stream,
                                                   Milliseconds sound_end,
                                                   std::uint32_t keyframe_ms, int classic_min) {
  if (stream.times.empty()) return nullptr;
  const Milliseconds face_end = length_of(stream);
  const Milliseconds longest = *std::max_element(stream.times.begin(), stream.times.end());
  const bool holds = sound_end > face_end + kVoicedKeyframeMax;
  if (longest <= kVoicedKeyframeMax && !holds) return nullptr;
  Cutter cutter(keyframe_ms, classic_min);
  Keyframe keyframe;
  for (std::size_t at = 0; at < stream.times.size(); ++at) {
    keyframe = keyframe_of(stream.negotiated[at]);
    cutter.add(keyframe, stream.times[at]);
  }
  if (holds) {
    const KeyframeTime time((sound_end - face_end).count());
    keyframe.time_ms = time.count();
    if (keyframe.place_ms) *keyframe.place_ms += time.count();
    cutter.add(keyframe, time);
  }
  return std::make_shared<const EncodedStream>(cutter.finish());
}

}  // namespace aucast::protocol
