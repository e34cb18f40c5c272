#include "client/app/commands/clocked_run.h"

#include <algorithm>
#include <optional>
#include <string>
#include <thread>

#include "client/app/steady.h"
#include "client/app/window/live_text.h"
#include "client/pipeline/face_pipeline.h"
#include "client/playback/playback_controller.h"
#include "common/log.h"

namespace aucast::app {
namespace {

using playback::PlaybackState;

/// Longest sleep, so that a signal is noticed soon.
constexpr Milliseconds kSleepMax{50};

}  // namespace

void run_clocked(const Assets& assets, const PlayerOptions& options,
                 playback::KeyframeSource& source, const std::function<bool()>& stop,
                 PlayerStats& stats) {
  playback::PlaybackController controller(options.playback.speed);
  controller.set_hold(options.playback.hold);
  pipeline::FacePipeline pipeline(assets.face, assets.rules,
                                  {options.face.mixer, options.playback.interpolation});
  std::optional<Instant> first;
  PlaybackState state = controller.state();
  while (!controller.over()) {
    const Instant now = steady_now();
    if (stop()) {
      source.stop();
      controller.stop(now);
      break;
    }
    const std::uint64_t played = controller.keyframes_played();
    const auto begun = controller.advance(now, source);
    // The end is measured where it is noticed, right after the position was due.
    if (controller.keyframes_played() != played) {
      stats.playback_seconds = seconds(now - *first);
      trace_reached(pipeline.received(), now);
    }
    if (controller.state() != state) {
      state = controller.state();
      spdlog::info("{}", playback::name(state));
    }
    if (begun) {
      static_cast<void>(pipeline.at(begun->cut_at));
      pipeline.begin_keyframe(begun->target.aus);
      if (!first) {
        first = now;
        stats.first_frame_ms = since_start_ms();
        const std::string objection = live_objection(options.playback, source.status());
        if (!objection.empty()) spdlog::warn("{}", objection);
      }
      continue;
    }
    static_cast<void>(pipeline.at(controller.moment().mu));
    if (const auto next = controller.next_position_at()) {
      std::this_thread::sleep_until(std::min(*next, now + kSleepMax));
    } else if (!controller.over()) {
      source.wait_until(now + kSleepMax);
    }
  }
  stats.take(controller);
}

}  // namespace aucast::app
