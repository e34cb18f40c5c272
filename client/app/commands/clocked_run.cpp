#include "client/app/commands/clocked_run.h"

#include <algorithm>
#include <functional>
#include <string>
#include <thread>

#include "client/app/live_text.h"
#include "client/app/loss_warnings.h"
#include "client/app/missing_aus.h"
#include "client/app/playback_meter.h"
#include "client/app/steady.h"
#include "client/pipeline/player.h"
#include "client/sound/sound_player.h"
#include "common/log.h"

namespace aucast::app {
namespace {

/// The longest wait, so that a signal is noticed soon.
constexpr Milliseconds kSleepMax{50};
/// The same while there is sound to be written.
constexpr Milliseconds kSoundEvery{10};

/// Waits until `next`, which is on the clock of `now`, but at most kSleepMax, or kSoundEvery if
/// `sounds`.
void wait(playback::Playback& playback, std::optional<Instant> next, Instant now, bool sounds) {
  const Duration most = sounds ? kSoundEvery : kSleepMax;
  if (next || playback.over()) {
    // Does not wait for the source: if that has the next keyframe already, the wait would end at
    // once.
    const Duration time = next ? *next - now : most;
    std::this_thread::sleep_for(std::clamp(time, Duration::zero(), most));
  } else {
    playback.wait_until(steady_now() + most);
  }
}

}  // namespace

void run_clocked(const Assets& assets, const PlayerOptions& options, playback::Playback& playback,
                 std::unique_ptr<sound::SoundOut> out, sound::SoundTrack* track,
                 const std::function<bool()>& stop, PlayerStats& stats) {
  const pipeline::AuMapping mapping = au_mapping(assets, options.face.mixer);
  pipeline::Player player(mapping, options.playback.interpolation);
  player.open(&playback);
  sound::SoundPlayer sound(std::move(out));
  sound.open(&playback, track);
  sound.set_volume(options.sound.volume);
  sound.set_muted(options.sound.mute);
  PlaybackMeter meter(stats);
  playback::PlaybackState state = playback.state();
  LossWarnings losses;
  MissingAus missing;
  while (!playback.over() || sound.rings_on()) {
    const Instant now = sound.now(steady_now());
    if (stop()) {
      playback.stop(now);
      break;
    }
    const auto begun = [&](const playback::KeyframeBegun& one) {
      meter.keyframe_begun(playback, one, now);
      const std::string warning = missing.look_at(mapping, one.target.aus);
      if (!warning.empty()) spdlog::warn("{}", warning);
    };
    player.advance(now, std::ref(begun));
    if (meter.count(playback, now)) {
      stats.first_frame_ms = since_start_ms();
      const LiveObjection objection = live_objection(options.playback, playback.status());
      if (objection != LiveObjection::None) spdlog::warn("{}", terminal_text(objection));
    }
    sound.advanced();
    sound.face_shown();
    if (sound.take_loss()) spdlog::warn("the sound device plays no more; going on without it");
    if (!playback.next_position_at()) {
      if (const std::string loss = losses.look_at(playback); !loss.empty())
        spdlog::warn("{}", loss);
    }
    if (playback.state() != state) {
      state = playback.state();
      spdlog::info("{}", playback::name(state));
    }
    if (!playback.over() || sound.rings_on()) {
      wait(playback, playback.next_position_at(), now, sound.sounds());
    }
  }
  stats.sound = sound.counts();
  stats.take(playback);
}

}  // namespace aucast::app
