#include "client/app/commands/clocked_run.h"

#include <algorithm>
#include <thread>

#include "client/app/playback_meter.h"
#include "client/app/steady.h"
#include "client/app/window/live_text.h"
#include "common/log.h"

namespace aucast::app {
namespace {

/// Longest sleep, so that a signal is noticed soon.
constexpr Milliseconds kSleepMax{50};

}  // namespace

void run_clocked(const Assets& assets, const PlayerOptions& options, playback::Playback& playback,
                 const std::function<bool()>& stop, PlayerStats& stats) {
  const pipeline::AuMapping mapping = au_mapping(assets, options.face.mixer);
  pipeline::Player player(mapping, options.playback.interpolation);
  player.open(&playback);
  PlaybackMeter meter(stats);
  playback::PlaybackState state = playback.state();
  while (!playback.over()) {
    const Instant now = steady_now();
    if (stop()) {
      playback.stop(now);
      break;
    }
    if (meter.advance(player, now)) {
      stats.first_frame_ms = since_start_ms();
      const std::string objection = live_objection(options.playback, playback.status());
      if (!objection.empty()) spdlog::warn("{}", objection);
    }
    if (playback.state() != state) {
      state = playback.state();
      spdlog::info("{}", playback::name(state));
    }
    if (const auto next = playback.next_position_at()) {
      std::this_thread::sleep_until(std::min(*next, now + kSleepMax));
    } else if (!playback.over()) {
      playback.wait_until(now + kSleepMax);
    }
  }
  stats.take(playback);
}

}  // namespace aucast::app
