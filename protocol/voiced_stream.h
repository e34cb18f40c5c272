#pragma once

#include <memory>

#include "common/time.h"
#include "protocol/encoded_stream.h"

namespace aucast::protocol {

/// Longest keyframe of a stream that goes with a voice. All voice that is heard during a keyframe
/// is sent in one go, just before the keyframe.
inline constexpr Milliseconds kVoicedKeyframeMax{250};

/// The stream as it goes with a voice that ends at `sound_end`: keyframes longer than
/// kVoicedKeyframeMax are cut into equal pieces on the straight line to their AUs, and the last
/// face is held until the voice is over, if the voice ends more than kVoicedKeyframeMax after the
/// stream. Null when the stream needs no change. `keyframe_ms` and `classic_min` are those of
/// StreamEncoder.
[[nodiscard]] std::shared_ptr<const EncodedStream> voiced_stream(const EncodedStream& stream,
                                                                 Milliseconds sound_end,
                                                                 std::uint32_t keyframe_ms,
                                                                 int classic_min);

}  // namespace aucast::protocol
