#pragma once

#include <cstdint>
#include <stop_token>

#include "protocol/stream_file.h"

namespace aucast::sources {

inline constexpr double kRateMax = 1000;

/// The same stream at `rate` keyframes a second, (0, kRateMax]. Intensities are interpolated
/// linearly between the given keyframes (an untimed one takes `keyframe_ms`), beginning at neutral,
/// as the player draws them. Times are differences of rounded places; the result ends where the
/// stream does. If asked to stop, returns what it has so far.
[[nodiscard]] protocol::StreamFile resample(const protocol::StreamFile& stream, double rate,
                                            std::uint32_t keyframe_ms,
                                            const std::stop_token& stop = {});

}  // namespace aucast::sources
