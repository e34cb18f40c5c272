#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "client/app/assets.h"
#include "client/app/notices.h"
#include "client/app/player_options.h"
#include "client/app/player_stats.h"
#include "client/app/window/files/export_session.h"
#include "client/app/window/files/file_names.h"
#include "client/app/window/files/file_session.h"
#include "client/app/window/files/gallery_session.h"
#include "client/app/window/leaving.h"
#include "client/app/window/making/composer_session.h"
#include "client/app/window/making/editor_session.h"
#include "client/app/window/making/face_session.h"
#include "client/app/window/playing/mirror_session.h"
#include "client/app/window/playing/playback_session.h"
#include "client/app/window/playing/stream_lister.h"
#include "client/app/window/recording/onset_log.h"
#include "client/app/window/settings/settings_session.h"
#include "client/app/window/shown_face.h"
#include "client/gui/model/gui_commands.h"
#include "client/gui/storage/kept_settings.h"

namespace aucast::app {

/// The sessions of the window, without the window itself: owns them all, and hands each command and
/// each chosen file to the one that it is about. Time is handed in. Assets, options and stats must
/// outlive it; the user may replace the face in `assets`. Thread: the player's.
class WindowSession {
 public:
  /// If `playback` is null, shows the neutral face.
  WindowSession(Assets& assets, const PlayerOptions& options,
                std::unique_ptr<playback::Playback> playback, PlayerStats& stats);
  WindowSession(const WindowSession&) = delete;
  WindowSession& operator=(const WindowSession&) = delete;
  /// Begins with the settings that the window remembered; call it first. `complaint`: what to show
  /// the user about reading them; empty: nothing.
  void begin_with(const gui::KeptSettings& settings, const std::string& complaint, Instant now);
  /// The settings that the window should remember now.
  [[nodiscard]] gui::KeptSettings kept() const;
  /// Sets the sound device for what plays; null: none.
  void set_sound(std::unique_ptr<sound::SoundOut> out, Instant now);

  /// Moves all that goes on by itself to `now`.
  void advance(Instant now);
  /// How long the window may wait before it calls advance() again.
  [[nodiscard]] Duration idle_time(Instant now) const;
  /// Carries out what a panel asked for, except LookFrom, TakePicture and ToggleVideo, which the
  /// window does.
  void apply(const gui::GuiCommand& command, Instant now);
  void toggle_pause(Instant now);
  // These act on the editor or the composer, whichever has its face shown. They do nothing while
  // playback's face is shown.
  void undo(Instant now);
  void redo(Instant now);
  void save(Instant now);
  /// Call it when face() has come on the display. `at`: when it did; `moved`: whether it differs
  /// from the last one.
  void face_shown(Instant at, bool moved);
  /// Call it when the user wants to leave. leaving().leaves() becomes true, unless something is
  /// unsaved or unfinished (a keyframe that was not added, a gallery, a GLB file). In that case the
  /// panels ask, and go on asking however often this is called.
  void ask_to_leave() { leaving_.wish(losses()); }
  /// Stops what plays, completes the statistics and hands out what played last; may be null.
  [[nodiscard]] std::unique_ptr<playback::Playback> finish(Instant now) {
    return playback_.finish(now);
  }

  /// What the window shows, for the names of files.
  [[nodiscard]] Named named() const;
  [[nodiscard]] ShownFace& face() { return face_; }
  [[nodiscard]] Notices& notices() { return notices_; }
  [[nodiscard]] SoundSession& sound() { return playback_.sound(); }
  [[nodiscard]] OnsetLog& onsets() { return onsets_; }

  [[nodiscard]] const PlayerOptions& options() const { return options_; }
  [[nodiscard]] const ShownFace& face() const { return face_; }
  [[nodiscard]] const Notices& notices() const { return notices_; }
  [[nodiscard]] const PlaybackSession& playback() const { return playback_; }
  [[nodiscard]] const EditorSession& editor() const { return editor_; }
  [[nodiscard]] const ComposerSession& composer() const { return composer_; }
  [[nodiscard]] const FaceSession& faces() const { return faces_; }
  [[nodiscard]] const MirrorSession& mirror() const { return mirror_; }
  [[nodiscard]] const StreamLister& lister() const { return lister_; }
  [[nodiscard]] const GallerySession& gallery() const { return gallery_; }
  [[nodiscard]] const ExportSession& exports() const { return exports_; }
  [[nodiscard]] const OnsetLog& onsets() const { return onsets_; }
  [[nodiscard]] const SettingsSession& settings() const { return settings_; }
  [[nodiscard]] const FileSession& files() const { return files_; }
  [[nodiscard]] const Leaving& leaving() const { return leaving_; }

 private:
  void ask_streams(const gui::RemoteSettings& settings, Instant now);
  void apply_composer(const gui::ComposerCommand& command, Instant now);
  void play_composition(Instant now);
  void save_composition(Instant now);
  [[nodiscard]] Result<std::string> save_composition(const std::filesystem::path& file);
  void save_all(Instant now);
  void apply_file(const gui::FileCommand& command, Instant now);
  void browse(gui::Purpose purpose);
  [[nodiscard]] Result<std::string> use(gui::Purpose purpose, const std::filesystem::path& file,
                                        Instant now);
  [[nodiscard]] Result<void> open(const std::filesystem::path& file, Instant now);
  void open_recent(const std::filesystem::path& file, Instant now);
  [[nodiscard]] Result<std::string> look_for_faces(const std::filesystem::path& folder,
                                                   Instant now);
  void show_saved_face(Instant now);
  [[nodiscard]] Result<void> show_face(const std::filesystem::path& folder, Instant now);
  [[nodiscard]] PlayerOptions options_as_shown() const;
  [[nodiscard]] bool makes_files() const;
  [[nodiscard]] Losses losses() const;
  [[nodiscard]] SettingsSession::Events settings_events();

  Assets& assets_;
  FaceSession faces_;
  const PlayerOptions& options_;
  pipeline::AuMapping mapping_;
  Notices notices_;
  std::vector<float> pose_;  ///< of face_, from which playback and editor go on
  PlaybackSession playback_;
  EditorSession editor_;
  ComposerSession composer_;
  MirrorSession mirror_;
  StreamLister lister_;
  GallerySession gallery_;
  ExportSession exports_;
  OnsetLog onsets_;
  SettingsSession settings_;
  ShownFace face_;
  FileSession files_;
  Leaving leaving_;
};

}  // namespace aucast::app
