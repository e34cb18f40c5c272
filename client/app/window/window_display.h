#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/player_options.h"
#include "client/app/start_times.h"
#include "client/app/video/face_view.h"
#include "client/app/window/pace_meter.h"
#include "client/app/window/window_keys.h"
#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"
#include "client/render/window.h"
#include "client/view/image.h"
#include "client/view/style.h"
#include "client/view/viewpoint.h"
#include "common/result.h"

namespace aucast::app {

/// The window on the screen as WindowLoop sees it: its input, the face, and the panels over it.
/// Thread: the player's.
class WindowDisplay {
 public:
  /// Returns the activations of the face for these AUs, one per channel.
  using FaceOf = std::function<std::vector<float>(const std::string& aus)>;

  WindowDisplay() = default;
  virtual ~WindowDisplay() = default;
  WindowDisplay(const WindowDisplay&) = delete;
  WindowDisplay& operator=(const WindowDisplay&) = delete;

  // === Input.

  /// Handles the events that have come. If there are none, waits for one for at most `wait_max`.
  virtual void poll(Duration wait_max) = 0;
  /// Whether the user has asked to close the window since the last call. The window stays open.
  [[nodiscard]] virtual bool take_closing() = 0;
  /// The path of the next file that was dropped on the window; empty: none.
  [[nodiscard]] virtual std::string next_dropped() = 0;
  /// The next key that was pressed and not typed into something; Key::None: there are no more.
  [[nodiscard]] virtual render::Key next_key() = 0;
  /// Whether there is input that only the next frame may see.
  [[nodiscard]] virtual bool input_waits() const = 0;
  /// Whether anything has happened since the last call that needs a new picture, whatever is shown:
  /// input, resizing, exposure, panels that come or go.
  [[nodiscard]] virtual bool take_redraw(Instant now) = 0;
  /// When take_redraw() is to be called next if nothing happens before; nullopt: no need to.
  [[nodiscard]] virtual std::optional<Instant> redraws_at(Instant now) const = 0;

  // === What the window does itself.

  virtual void set_title(const std::string& title) = 0;
  virtual void look_from(view::ViewpointPreset preset) = 0;
  /// Carries out an act, except Leave and CloseNearest.
  virtual void act(WindowAct act, Instant now) = 0;
  /// Closes the topmost thing that is open, or ends full screen. Returns the commands that the
  /// caller must carry out for this.
  [[nodiscard]] virtual gui::GuiCommands close_nearest(const gui::GuiModel& shown, Instant now) = 0;

  // === Pictures.

  /// Call it when the assets have another face. The new face is seen from the same side and as
  /// large as the one before.
  [[nodiscard]] virtual Result<void> change_face() = 0;
  /// Goes on with the small pictures that the panels lack. Returns true if one was made.
  [[nodiscard]] virtual bool make_thumbnails(const FaceOf& face_of) = 0;
  /// Whether make_thumbnails() waits for a face that is being read.
  [[nodiscard]] virtual bool thumbnails_wait() const = 0;
  /// Draws the face and the panels, and appends the commands of the user to `commands`. `moved`:
  /// whether `activations`, one per channel, or `hair` differ from the last ones. Returns how long
  /// that took, with `mix` 0.
  [[nodiscard]] virtual FrameTimes draw(const std::vector<float>& activations,
                                        const face::HairSway& hair, bool moved,
                                        const view::Style& style, const gui::GuiModel& model,
                                        gui::GuiCommands& commands) = 0;
  /// A picture, `width` times `height` pixels, of the face that was drawn last. It does not depend
  /// on what covers the window.
  [[nodiscard]] virtual Result<view::Image> picture(int width, int height, Sharpness sharpness,
                                                    const view::Style& style) = 0;
  /// The part of the window that the panel leaves free, in pixels.
  virtual void free_size(int& width, int& height) const = 0;
  /// All of the window, in pixels.
  virtual void whole_size(int& width, int& height) const = 0;
  [[nodiscard]] virtual bool full_screen() const = 0;
  /// Scale of the screen; 1: 96 dots per inch.
  [[nodiscard]] virtual float scale() const = 0;
};

/// Opens the window with OpenGL. `assets` and `output` must outlive it. `start_times`: measures the
/// stages of opening the window.
[[nodiscard]] Result<std::unique_ptr<WindowDisplay>> open_display(const Assets& assets,
                                                                  const OutputOptions& output,
                                                                  StartTimes& start_times);

}  // namespace aucast::app
