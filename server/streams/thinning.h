#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "protocol/packet.h"

namespace aucast::server {

/// The bytes that the headers of TCP (with time stamps) and IPv4 add to every packet that is sent
/// alone.
inline constexpr std::size_t kHeaderBytes = 52;

/// Thins a stream for links of `kbits_per_second`, headers included, at every level. Keyframes that
/// come too soon are merged into the next one that fits; that one lasts as long as all of them, so
/// the stream keeps its length. From its beginning to any keyframe's end the thinned stream needs
/// no more bits than the link carries in that time plus a second; the exception is the last
/// keyframe, which is always sent. An untimed keyframe takes `keyframe_ms` and stays untimed unless
/// it is merged. All keyframes must be full ones. When asked to stop, returns what it has so far.
[[nodiscard]] std::vector<protocol::Keyframe> thinned(std::span<const protocol::Keyframe> keyframes,
                                                      std::uint32_t keyframe_ms,
                                                      std::uint32_t kbits_per_second,
                                                      const std::stop_token& stop = {});

/// Gives a keyframe `time_ms`, the sum of its own time and that of the keyframes merged into it, or
/// the longest time that the protocol allows.
void give_time(protocol::Keyframe& keyframe, std::uint64_t time_ms);

}  // namespace aucast::server
