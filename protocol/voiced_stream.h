#pragma once

#include <memory>

#include "common/time.h"
#include "protocol/encoded_stream.h"

namespace aucast::protocol {

/// Longest keyframe of a stream that goes with a voice: what is heard during one goes out before
/// it, all at once.
inline constexpr Milliseconds kVoicedKeyframeMax{250};

/// The stream as it goes with a voice that ends at `sound_end`: keyframes longer than
/// kVoicedKeyframeMax are cut into equal pieces on the straight line to their AUs, and the last
/// face is held until the sound is over. Null when the stream is already like that; a sound that
/// ends up to kVoicedKeyframeMax after the face needs no holding. `keyframe_ms` and `classic_min`
/// as in StreamEncoder.
[[nodiscard]] std::shared_ptr<const EncodedStream> voiced_stream(const EncodedStream& stream,
                                                                 Milliseconds sound_end,
                                                                 std::uint32_t keyframe_ms,
                                                                 int classic_min);

}  // namespace aucast::protocol
