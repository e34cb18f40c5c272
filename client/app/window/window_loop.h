#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/app/start_times.h"
#include "client/app/window/pace_meter.h"
#include "client/app/window/settings/window_settings.h"
#include "client/app/window/window_display.h"
#include "client/app/window/window_pictures.h"
#include "client/app/window/window_session.h"
#include "client/gui/model/redraw.h"

namespace aucast::app {

/// What the window does from frame to frame: waits for input, no longer than the session may wait;
/// passes the user's commands to the session; draws if something differs from what is shown; and
/// keeps what is worth remembering. The constructor's arguments must outlive it. Thread: the
/// player's.
class WindowLoop {
 public:
  /// What the loop works with. `now`: the clock.
  struct Parts {
    WindowSession& session;
    WindowDisplay& display;
    WindowSettings& settings;
    const Assets& assets;
    const PlayerOptions& options;
    PlayerStats& stats;
    StartTimes& start_times;
    std::function<Instant()> now;
  };
  explicit WindowLoop(const Parts& parts);

  /// One turn of the loop; the body of this function gives an overview. `stopped_from_outside`:
  /// whether to leave without asking.
  void tick(bool stopped_from_outside);
  /// Whether the user has left, playing has ended with --exit-at-end, or outcome() has an error.
  [[nodiscard]] bool done() const;
  /// If the window cannot go on, fails with the error that stopped it.
  [[nodiscard]] Result<void> outcome() const;
  /// Ends a video and keeps the settings. Call it last.
  void finish();

 private:
  [[nodiscard]] Instant now() const { return parts_.now(); }
  [[nodiscard]] Duration wait_max() const;
  void carry_out(const gui::GuiCommand& command);
  void act(WindowAct act);
  void handle_keys();
  void show_new_face();
  void keep_recent();
  void keep_settings();
  void show_title();
  void take_picture();
  void draw();
  void count_frame(const FrameTimes& times, bool moved, Instant end);
  /// Something has happened that the next pictures must show.
  void changed() { frames_due_ = gui::kFramesAfterChange; }

  Parts parts_;
  WindowSession& session_;
  WindowDisplay& display_;
  WindowPictures pictures_;
  PaceMeter pace_;
  std::vector<gui::PaceRow> pace_rows_;  ///< what pace_ measured last, in the language in use
  std::vector<float> shown_activations_;
  face::HairSway shown_hair_;
  gui::GuiModel shown_model_;
  gui::GuiCommands commands_;  ///< of the panels, as of the last picture
  std::string title_;
  std::uint64_t shown_face_;  ///< face_changes() of the session when this face was shown
  // As in the settings that were kept last.
  std::vector<std::string> kept_addresses_;
  std::vector<std::string> kept_files_;
  std::uint64_t kept_face_;
  int frames_due_ = gui::kFramesAfterChange;
  bool picture_due_ = false;  ///< a picture is to be saved of what is drawn next
  bool leaving_ = false;
  std::optional<Error> failed_;
};

}  // namespace aucast::app
