#include "client/app/playback_meter.h"

#include <utility>

#include "client/app/steady.h"
#include "common/log.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

/// Logs for scripts/live_delay.py which face was reached when, by the clock that all programs on
/// this computer share (CLOCK_MONOTONIC).
void trace_reached(const AuFrame& aus, Instant now) {
  if (!spdlog::should_log(spdlog::level::trace)) return;
  spdlog::trace("reached {{{}}} at {:.6f}", protocol::format_au_set(aus),
                seconds(now.time_since_epoch()));
}

}  // namespace

void PlaybackMeter::keyframe_begun(const playback::Playback& playback,
                                   const playback::KeyframeBegun& keyframe, Instant now) {
  count_played(playback, now);
  under_way_ = keyframe.target.aus;
  if (!first_begin_) first_begin_ = now;
}

bool PlaybackMeter::count(const playback::Playback& playback, Instant now) {
  count_played(playback, now);
  return first_begin_ && !std::exchange(told_, true);
}

void PlaybackMeter::count_played(const playback::Playback& playback, Instant now) {
  const std::uint64_t played = playback.keyframes_played();
  if (std::exchange(played_, played) == played) return;
  trace_reached(under_way_, now);
  if (first_begin_) stats_.playback_seconds = seconds(now - *first_begin_);
}

void PlaybackMeter::begin_again() {
  first_begin_.reset();
  told_ = false;
  played_ = 0;
}

}  // namespace aucast::app
