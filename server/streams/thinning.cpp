#include "server/streams/thinning.h"

#include <algorithm>
#include <utility>

#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

constexpr auto kLongest = static_cast<std::uint64_t>(protocol::kKeyframeTimeMsMax);

double bits_on_the_wire(const protocol::Keyframe& keyframe) {
  return static_cast<double>((encode(keyframe).size() + kHeaderBytes) * 8);
}

}  // namespace

void give_time(protocol::Keyframe& keyframe, std::uint64_t time_ms) {
  keyframe.time_ms = static_cast<std::uint32_t>(std::min(time_ms, kLongest));
}

std::vector<protocol::Keyframe> thinned(std::span<const protocol::Keyframe> keyframes,
                                        std::uint32_t keyframe_ms, std::uint32_t kbits_per_second,
                                        const std::stop_token& stop) {
  // Bits a millisecond are kilobits a second.
  const auto rate = static_cast<double>(kbits_per_second);
  const double most = rate * 1000;
  double there = most;
  std::uint64_t time_ms = 0;
  std::vector<protocol::Keyframe> kept;
  for (std::size_t i = 0; i < keyframes.size() && !stop.stop_requested(); ++i) {
    protocol::Keyframe keyframe = keyframes[i];
    const std::uint64_t own_ms = keyframe.time_ms.value_or(keyframe_ms);
    time_ms += own_ms;
    if (time_ms != own_ms) give_time(keyframe, time_ms);
    // What the keyframe's own time brings must pay for it.
    const double left = there - bits_on_the_wire(keyframe) + rate * static_cast<double>(time_ms);
    if (left < 0 && i + 1 < keyframes.size()) continue;
    there = std::min(left, most);
    kept.push_back(std::move(keyframe));
    time_ms = 0;
  }
  return kept;
}

}  // namespace aucast::server
