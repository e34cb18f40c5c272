#include "common/sources/record_timeline.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "common/check.h"
#include "common/time.h"
#include "protocol/limits.h"

namespace aucast::sources {

std::vector<protocol::Keyframe> held_face(const std::vector<AuTerm>& shown, Milliseconds pause) {
  constexpr Milliseconds kPauseLeast{100};
  constexpr Milliseconds kOneMax{protocol::kKeyframeTimeMsMax};
  std::vector<protocol::Keyframe> keyframes;
  if (pause < kPauseLeast) return keyframes;
  for (Milliseconds left = pause; left.count() > 0; left -= kOneMax) {
    protocol::Keyframe held;
    held.terms = shown;
    held.time_ms = static_cast<std::uint32_t>(std::min(left, kOneMax).count());
    keyframes.push_back(std::move(held));
  }
  return keyframes;
}

std::vector<protocol::Keyframe> RecordTimeline::add(const protocol::Keyframe& keyframe,
                                                    SteadyTime now, bool free) {
  AUCAST_CHECK(keyframe.time_ms.has_value());
  std::vector<protocol::Keyframe> lines;
  if (!begin_) {
    begin_ = now;
    place_ = Milliseconds{0};
  } else if (free) {
    const auto pause = std::chrono::round<Milliseconds>(now - *begin_) - place_;
    lines = held_face(shown_, pause);
    if (!lines.empty()) place_ += pause;
  }
  shown_ = keyframe.terms;
  place_ += Milliseconds(*keyframe.time_ms);
  lines.push_back(keyframe);
  return lines;
}

}  // namespace aucast::sources
