#include "common/sources/record_timeline.h"

#include <algorithm>

#include "common/check.h"
#include "common/time.h"
#include "protocol/limits.h"

namespace aucast::sources {
namespace {

/// A gap shorter than this is no pause: it is how late a busy machine may be.
constexpr std::int64_t kPauseMs = 100;

}  // namespace

std::vector<protocol::Keyframe> RecordTimeline::add(const protocol::Keyframe& keyframe,
                                                    SteadyTime now, bool free) {
  AUCAST_CHECK(keyframe.time_ms.has_value());
  std::vector<protocol::Keyframe> lines;
  if (!begin_) {
    begin_ = now;
    place_ms_ = 0;
  } else if (free) {
    std::int64_t pause_ms =
        whole_milliseconds(seconds(now - *begin_)) - static_cast<std::int64_t>(place_ms_);
    if (pause_ms < kPauseMs) pause_ms = 0;
    while (pause_ms > 0) {
      protocol::Keyframe held;
      held.terms = shown_;
      held.time_ms = static_cast<std::uint32_t>(
          std::min<std::int64_t>(pause_ms, protocol::kKeyframeTimeMsMax));
      pause_ms -= *held.time_ms;
      place_ms_ += *held.time_ms;
      lines.push_back(std::move(held));
    }
  }
  shown_ = keyframe.terms;
  place_ms_ += *keyframe.time_ms;
  lines.push_back(keyframe);
  return lines;
}

}  // namespace aucast::sources
