#include "client/app/playback_meter.h"

#include <functional>
#include <utility>

#include "client/app/steady.h"
#include "common/log.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

/// For scripts/live_delay.py: which face was reached when, by the clock that all programs of this
/// computer share (CLOCK_MONOTONIC).
void trace_reached(const AuFrame& aus, Instant now) {
  if (!spdlog::should_log(spdlog::level::trace)) return;
  spdlog::trace("reached {{{}}} at {:.6f}", protocol::format_au_set(aus),
                seconds(now.time_since_epoch()));
}

}  // namespace

bool PlaybackMeter::advance(pipeline::Player& player, Instant now,
                            const pipeline::Player::OnBegin& on_begin) {
  const playback::Playback* const playback = player.playback();
  if (playback == nullptr) return false;
  const bool had_begun = first_begin_.has_value();
  const auto begin = [&](const playback::KeyframeBegun& begun) {
    count(*playback, now);
    under_way_ = begun.target.aus;
    if (!first_begin_) first_begin_ = now;
    if (on_begin) on_begin(begun);
  };
  player.advance(now, std::ref(begin));
  count(*playback, now);
  return !had_begun && first_begin_;
}

void PlaybackMeter::count(const playback::Playback& playback, Instant now) {
  const std::uint64_t played = playback.keyframes_played();
  if (std::exchange(played_, played) == played) return;
  trace_reached(under_way_, now);
  if (first_begin_) stats_.playback_seconds = seconds(now - *first_begin_);
}

void PlaybackMeter::begin_again() {
  first_begin_.reset();
  played_ = 0;
}

}  // namespace aucast::app
