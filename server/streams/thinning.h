#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "protocol/packet.h"

namespace aucast::server {

/// What the headers of TCP and IPv4 with time stamps add to every packet that goes out alone.
inline constexpr std::size_t kHeaderBytes = 52;

/// The stream for links of `kbits_per_second`, headers included, at every level: keyframes that
/// come too soon are merged into the next one that fits, which for states means that the newest
/// wins and takes the time of all of them. So the stream keeps its length. From its beginning to
/// any keyframe's end it needs no more bits than there are in that time and a second; only the last
/// keyframe is sent in any case. Untimed keyframes count as `keyframe_ms` and stay untimed unless
/// they are merged. All keyframes must be full ones.
[[nodiscard]] std::vector<protocol::Keyframe> thinned(std::span<const protocol::Keyframe> keyframes,
                                                      std::uint32_t keyframe_ms,
                                                      std::uint32_t kbits_per_second);

/// Gives a keyframe the time of those that are merged into it, as far as the protocol lets it.
void give_time(protocol::Keyframe& keyframe, std::uint64_t time_ms);

}  // namespace aucast::server
