#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/packet.h"

namespace aucast::protocol {

/// What turns the face of `from` into that of `to`, in the changes-only form with the timing of
/// `to`. Both must be full keyframes.
[[nodiscard]] Keyframe changes_between(const Keyframe& from, const Keyframe& to);

/// A stream for who understands the changes-only form: a packet per keyframe. Those are full that
/// come first, that are no longer that way, and that would otherwise begin later than
/// kFullKeyframeEvery after the last full one (untimed keyframes count as `keyframe_ms`). All
/// keyframes must be full ones.
class ChangesEncoder {
 public:
  explicit ChangesEncoder(std::uint32_t keyframe_ms) : keyframe_ms_(keyframe_ms) {}

  [[nodiscard]] std::string next(const Keyframe& keyframe);

 private:
  std::uint32_t keyframe_ms_;
  std::optional<Keyframe> last_;
  std::uint64_t since_full_ms_ = 0;
};

/// The same for a whole stream.
[[nodiscard]] std::vector<std::string> encode_changes(std::span<const Keyframe> keyframes,
                                                      std::uint32_t keyframe_ms);

}  // namespace aucast::protocol
