#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "protocol/packet.h"

namespace aucast::server {

/// What the headers of TCP and IPv4 with time stamps add to every packet that goes out alone.
inline constexpr std::size_t kHeaderBytes = 52;

/// The stream for links of `kbits_per_second`, headers included, at every level: keyframes that
/// come too soon are merged into the next one that fits: the newest wins and takes the time of all
/// of them, so the stream keeps its length. From its beginning to any keyframe's end it needs no
/// more bits than the link carries in that time and one second more; only the last keyframe is
/// always sent. Untimed keyframes count as `keyframe_ms` and stay untimed unless they are merged.
/// All keyframes must be full ones. Asked to stop, the result breaks off.
[[nodiscard]] std::vector<protocol::Keyframe> thinned(std::span<const protocol::Keyframe> keyframes,
                                                      std::uint32_t keyframe_ms,
                                                      std::uint32_t kbits_per_second,
                                                      const std::stop_token& stop = {});

/// Adds to a keyframe the time of those that are merged into it, as far as the protocol allows.
void give_time(protocol::Keyframe& keyframe, std::uint64_t time_ms);

}  // namespace aucast::server
