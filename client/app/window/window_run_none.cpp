#include "client/app/window/window_run.h"

namespace aucast::app {

Result<void> run_window(Assets&, const PlayerOptions&, std::unique_ptr<playback::Playback>&,
                        std::unique_ptr<sound::SoundOut>, WindowSettings&,
                        const std::function<bool()>&, PlayerStats&) {
  return Error{ErrorKind::Failed,
               "this face-player was built without OpenGL (AUCAST_BUILD_RENDER=OFF): no window; "
               "use --headless"};
}

}  // namespace aucast::app
