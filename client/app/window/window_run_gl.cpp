#include "client/app/window/window_run.h"

#include <utility>

#include "client/app/start_times.h"
#include "client/app/steady.h"
#include "client/app/window/window_display.h"
#include "client/app/window/window_loop.h"
#include "client/app/window/window_session.h"

namespace aucast::app {

Result<void> run_window(Assets& assets, const PlayerOptions& options,
                        std::unique_ptr<playback::Playback>& playback,
                        std::unique_ptr<sound::SoundOut> out, WindowSettings& settings,
                        const std::function<bool()>& stop, PlayerStats& stats) {
  StartTimes start_times;
  WindowSession session(assets, options, std::move(playback), stats);
  const bool heard = out != nullptr;
  session.set_sound(std::move(out), steady_now());
  // The list of devices shows the user that sound would be possible.
  if (!heard) session.apply(gui::SoundCommand(gui::ListDevices{}), steady_now());
  session.begin_with(settings.in_force(), settings.complaint(), steady_now());
  start_times.passed("session");

  const auto run = [&]() -> Result<void> {
    const auto display = open_display(assets, options.output, start_times);
    if (!display) return display.error();
    const std::filesystem::path& onsets = options.output.onsets;
    if (auto logged = onsets.empty() ? Result<void>() : session.onsets().begin(onsets); !logged) {
      return logged;
    }
    WindowLoop loop(
        {session, **display, settings, assets, options, stats, start_times, steady_now});
    while (!loop.done()) loop.tick(stop());
    loop.finish();
    const auto ended = loop.outcome();
    // What there is of the table is kept in both cases.
    return ended ? session.onsets().end() : ended;
  };
  const auto outcome = run();
  playback = session.finish(steady_now());
  return outcome;
}

}  // namespace aucast::app
