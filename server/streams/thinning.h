#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// The same for a stream whose keyframes come one by one and cannot be looked ahead in: one that
/// comes too soon waits until there are bits for it, and the next one takes its place and its time.
/// In any stretch no more bits are spent than there are in its time and a second, or than one
/// keyframe needs that is larger than that. Times are seconds of one clock.
class LiveThinning {
 public:
  /// 0 kilobits: everything passes at once.
  LiveThinning(std::uint32_t keyframe_ms, std::uint32_t kbits_per_second)
      : keyframe_ms_(keyframe_ms), rate_(kbits_per_second * 1000.0), there_(rate_) {}

  /// A full keyframe.
  void push(protocol::Keyframe keyframe);
  /// The one that waits, when its time has come.
  [[nodiscard]] std::optional<protocol::Keyframe> pop(double now);
  /// The one that waits, without looking at the time: nothing comes after it.
  [[nodiscard]] std::optional<protocol::Keyframe> take_last();
  /// When pop() has something; nothing while none waits.
  [[nodiscard]] std::optional<double> due() const;

 private:
  std::uint32_t keyframe_ms_;
  double rate_;      ///< bits a second
  double there_;     ///< bits at the moment `at_`; less than none after a large keyframe
  double at_ = 0;    ///< seconds
  double bits_ = 0;  ///< of the one that waits
  std::optional<protocol::Keyframe> waiting_;
};

}  // namespace aucast::server
