#pragma once

#include <filesystem>
#include <functional>

#include "client/app/assets.h"
#include "client/app/notices.h"
#include "client/app/player_options.h"
#include "client/gui/gui_commands.h"
#include "client/gui/gui_model.h"
#include "client/gui/kept_settings.h"
#include "client/pipeline/au_mapping.h"

namespace aucast::app {

/// What the user sets and the window keeps: how AUs become a face, how the face and the panels
/// look, where pictures go. What the constructor takes must outlive it. Thread: the player's.
class SettingsSession {
 public:
  struct Events {
    /// AUs become a face in another way: the mapping or the interpolation is another one.
    std::function<void()> on_animation;
    std::function<void()> on_language;
    /// Pictures go to this folder from now on.
    std::function<void(const std::filesystem::path& folder)> on_picture_folder;
  };
  SettingsSession(const Assets& assets, const PlayerOptions& options, pipeline::AuMapping& mapping,
                  Notices& notices, Events events);

  /// Begins with those that the window remembered.
  void begin_with(const gui::KeptSettings& kept, Instant now);
  /// Adds those that it should remember.
  void keep(gui::KeptSettings& kept) const;

  void apply(const gui::SettingsCommand& command, Instant now);
  void change_pictures(const gui::PictureSettings& settings);
  /// What the command line would have to say for pictures as the window's.
  [[nodiscard]] PlayerOptions applied(PlayerOptions options) const;

  [[nodiscard]] const gui::AnimationSettings& animation() const { return animation_; }
  [[nodiscard]] const gui::RenderingSettings& rendering() const { return rendering_; }
  [[nodiscard]] const gui::PictureSettings& pictures() const { return pictures_; }
  [[nodiscard]] const gui::DisplayView& display() const { return display_; }

 private:
  void change_animation(const gui::AnimationSettings& settings, Instant now);
  void change_display(const gui::DisplaySettings& settings, Instant now);

  const Assets& assets_;
  pipeline::AuMapping& mapping_;
  Notices& notices_;
  Events events_;
  gui::AnimationSettings animation_;
  gui::RenderingSettings rendering_;
  gui::PictureSettings pictures_;
  gui::DisplayView display_{{}, "en", {}};
};

}  // namespace aucast::app
