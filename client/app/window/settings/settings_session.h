#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "client/app/assets.h"
#include "client/app/notices.h"
#include "client/app/player_options.h"
#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/storage/kept_settings.h"
#include "client/pipeline/au_mapping.h"
#include "client/pipeline/idle_face.h"

namespace aucast::app {

/// The settings that the window keeps: how AUs become a face, how the face and the panels look,
/// where pictures go. The constructor's arguments must outlive it. Thread: the player's.
class SettingsSession {
 public:
  struct Events {
    /// The mapping or the interpolation has changed.
    std::function<void()> on_animation;
    std::function<void()> on_language;
    /// The folder for pictures has changed.
    std::function<void(const std::filesystem::path& folder)> on_picture_folder;
  };
  SettingsSession(const Assets& assets, const PlayerOptions& options, pipeline::AuMapping& mapping,
                  Notices& notices, Events events);

  /// Begins with the settings that the window remembered.
  void begin_with(const gui::KeptSettings& kept, Instant now);
  /// Adds the settings that the window should remember.
  void keep(gui::KeptSettings& kept) const;

  void apply(const gui::SettingsCommand& command, Instant now);
  void change_pictures(const gui::PictureSettings& settings);
  /// The options with which the command line would make pictures like the window's.
  [[nodiscard]] PlayerOptions applied(PlayerOptions options) const;

  [[nodiscard]] const gui::AnimationSettings& animation() const { return animation_; }
  [[nodiscard]] const gui::RenderingSettings& rendering() const { return rendering_; }
  /// What the face in the window does by itself.
  [[nodiscard]] pipeline::IdleOptions idle() const;
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
  std::optional<std::uint64_t> idle_seed_;
  gui::PictureSettings pictures_;
  gui::DisplayView display_{{}, "en", {}};
};

}  // namespace aucast::app
