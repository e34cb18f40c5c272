#include "client/net/live_timing.h"

#include <algorithm>
#include <chrono>

namespace aucast::net {
namespace {

/// How much is buffered in addition to the jitter, and the most that is buffered in all.
constexpr Milliseconds kDelayMargin{60};
constexpr Milliseconds kDelayMax{4'000};

/// A lost packet comes again after a round trip, three packets behind it and some jitter.
Milliseconds delay_for(Duration round_trip) {
  return std::chrono::duration_cast<Milliseconds>(round_trip * 5 / 2);
}

}  // namespace

void LiveTiming::connected(Duration round_trip) {
  first_delay_ = std::clamp(delay_for(round_trip), options_.live_delay,
                            std::max(kDelayMax, options_.live_delay));
}

void LiveTiming::begin_again() {
  measured_since_.reset();
  jitter_.begin_again();
  playout_.begin_again();
}

std::optional<Milliseconds> LiveTiming::arrived(playback::Keyframe& keyframe, Milliseconds untimed,
                                                std::optional<Milliseconds> place) {
  const Milliseconds time = keyframe.time.value_or(untimed);
  if (options_.low_delay) {
    keyframe.due = playout_.arrived(*keyframe.arrived, time, place);
    return std::nullopt;
  }
  return options_.adapt ? measured(*keyframe.arrived, time) : std::nullopt;
}

/// The first keyframe says nothing about the jitter: a client that joins is sent one that has
/// already begun.
std::optional<Milliseconds> LiveTiming::measured(Instant now, Milliseconds time) {
  if (!measured_since_) {
    measured_since_ = now;
    return std::nullopt;
  }
  jitter_.arrived(now, time);
  const auto spread =
      std::chrono::duration_cast<Milliseconds>(jitter_.spread().value_or(Duration{}));
  const Milliseconds delay = std::min(spread + kDelayMargin, kDelayMax);
  const bool enough = now - *measured_since_ >= playback::JitterMeter::kWindow;
  return enough ? delay : std::max(delay, first_delay_);
}

Milliseconds LiveTiming::low_delay() const {
  return std::chrono::round<Milliseconds>(playout_.delay());
}

}  // namespace aucast::net
