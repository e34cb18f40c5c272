#pragma once

#include <cstdint>
#include <stop_token>

#include "protocol/stream_file.h"

namespace aucast::sources {

inline constexpr double kRateMax = 1000;

/// The same face at `rate` keyframes a second, (0, kRateMax]: between the given keyframes (an
/// untimed one takes `keyframe_ms`) intensities go in straight lines, from neutral on, as the
/// player draws them. Durations are differences of rounded places; the last place is that of the
/// stream. Asked to stop, the result breaks off.
[[nodiscard]] protocol::StreamFile resample(const protocol::StreamFile& stream, double rate,
                                            std::uint32_t keyframe_ms,
                                            const std::stop_token& stop = {});

}  // namespace aucast::sources
