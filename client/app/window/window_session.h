#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
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
#include "client/app/window/files/shown.h"
#include "client/app/window/leaving.h"
#include "client/app/window/making/composer_session.h"
#include "client/app/window/making/editor_session.h"
#include "client/app/window/making/face_session.h"
#include "client/app/window/playing/mirror_session.h"
#include "client/app/window/playing/playback_session.h"
#include "client/app/window/playing/stream_lister.h"
#include "client/app/window/recording/onset_session.h"
#include "client/app/window/settings/settings_session.h"
#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/storage/kept_settings.h"
#include "client/pipeline/hair_swing.h"
#include "client/pipeline/idle_face.h"

namespace aucast::app {

/// What happens in the window, without the window itself. Passes each command to its session,
/// decides which session's face is shown, puts together what the panels show of them, and owns what
/// the sessions share: the mapping of AUs to a face, notices, leaving. Time is handed in. Assets,
/// options and stats must outlive it. The user may replace the face in `assets`. Thread: the
/// player's.
class WindowSession {
 public:
  /// If `playback` is null, shows the neutral face.
  WindowSession(Assets& assets, const PlayerOptions& options,
                std::unique_ptr<playback::Playback> playback, PlayerStats& stats);
  /// Begins with the settings that the window remembered; call it first. `complaint`: what to show
  /// the user about reading them; empty: nothing.
  void begin_with(const gui::KeptSettings& settings, const std::string& complaint, Instant now);
  /// The settings that the window should remember now.
  [[nodiscard]] gui::KeptSettings kept() const;
  WindowSession(const WindowSession&) = delete;
  WindowSession& operator=(const WindowSession&) = delete;

  /// Sets the sound device for what plays; null: none.
  void set_sound(std::unique_ptr<sound::SoundOut> out, Instant now);
  void set_sound_tap(sound::SoundPlayer::Tap tap) { playback_.sound().set_tap(std::move(tap)); }
  /// Changes the volume by `by` percent.
  void change_volume(int by, Instant now) { playback_.sound().change_volume(by, now); }
  /// Logs in this file when each face is shown, from now on.
  [[nodiscard]] Result<void> log_onsets(const std::filesystem::path& file) {
    return onsets_.begin(file);
  }
  [[nodiscard]] Result<void> end_onsets() { return onsets_.end(); }
  /// Call it when the face of activations() has come on the display. `at`: when it did; `moved`:
  /// whether it differs from the last one.
  void face_shown(Instant at, bool moved);

  /// Moves playback to `now`.
  void advance(Instant now);
  /// Carries out what a panel asked for, except LookFrom, TakePicture and ToggleVideo, which the
  /// window does.
  void apply(const gui::GuiCommand& command, Instant now);
  void toggle_pause(Instant now);

  // These act on the editor or the composer, whichever has its face shown. They do nothing while
  // playback's face is shown.
  void undo(Instant now);
  void redo(Instant now);
  void save(Instant now);

  /// The face at `now`, one activation per channel. Overwritten by the next call.
  [[nodiscard]] const std::vector<float>& activations(Instant now);
  /// Where that face's hair hangs. It swings while the face is played, and settles when it is not;
  /// a face that is edited, or sought while it stands, is a still.
  [[nodiscard]] const face::HairSway& hair() const { return hair_sway_; }
  [[nodiscard]] const ComposerSession& composer() const { return composer_; }
  /// The AUs of which the face is made now, after the rules; nullopt if it is made of muscles.
  [[nodiscard]] std::optional<AuFrame> aus_shown() const;
  /// If the face is edited muscle by muscle, what it shows, in a form for file names; else empty.
  [[nodiscard]] std::string edited_shown() const {
    return shown_ == Shown::Editor && !aus_shown() ? editor_.made_of() : std::string();
  }
  /// The number of the keyframe under way, from 1; 0: none, or the face is not playback's.
  [[nodiscard]] std::uint64_t keyframe_shown() const {
    return shown_ == Shown::Playback ? playback_.keyframe() : 0;
  }
  /// How often the face in the assets has been replaced; each time, what was made from it must be
  /// made anew.
  [[nodiscard]] std::uint64_t face_changes() const { return faces_.changes(); }
  /// What the panels show, without what the window itself does: videos and the pace of drawing.
  [[nodiscard]] gui::GuiModel model() const;
  /// "lecture.example.org/talk - AUcast - playing", for the title of the window.
  [[nodiscard]] std::string title() const { return playback_.title(); }
  /// Addresses that answered, the newest first.
  [[nodiscard]] const std::vector<std::string>& recent() const {
    return playback_.servers().recent();
  }
  [[nodiscard]] const std::vector<std::string>& recent_files() const { return files_.recent(); }
  /// How long the window may wait before it calls advance() again.
  [[nodiscard]] Duration idle_time(Instant now) const;

  /// Whether playing has come to its end; false if nothing has been opened.
  [[nodiscard]] bool over() const { return playback_.over(); }
  /// Call it when the user wants to leave. leaving() becomes true, unless something is unsaved or
  /// unfinished (a keyframe that was not added, a gallery, a GLB file). In that case the panels
  /// ask, and go on asking however often this is called.
  void ask_to_leave() { leaving_.wish(losses()); }
  [[nodiscard]] bool leaving() const { return leaving_.leaves(); }
  [[nodiscard]] const gui::AnimationSettings& animation() const { return settings_.animation(); }
  [[nodiscard]] const gui::RenderingSettings& rendering() const { return settings_.rendering(); }
  [[nodiscard]] const gui::DisplaySettings& display() const { return settings_.display().settings; }
  [[nodiscard]] const gui::PictureSettings& pictures() const { return settings_.pictures(); }
  /// The path of a new file for a picture or a video of what is shown.
  [[nodiscard]] Result<std::filesystem::path> picture_file(const std::string& ending) const;
  /// Shows a sentence to the user for a while.
  void say(const std::string& text, bool bad, Instant now) { notices_.say(text, bad, now); }

  /// Stops what plays, completes the statistics and hands out what played last; may be null.
  [[nodiscard]] std::unique_ptr<playback::Playback> finish(Instant now);

 private:
  void look(Instant now);
  void swing_hair(Instant now);
  void show(Shown shown);
  void show_edited(Shown shown, Instant now);
  [[nodiscard]] PlayerOptions options_as_shown() const;
  void ask_streams(const gui::RemoteSettings& settings, Instant now);
  void apply_composer(const gui::ComposerCommand& command, Instant now);
  void play_composition(Instant now);
  void apply_file(const gui::FileCommand& command, Instant now);
  void browse(gui::Purpose purpose);
  [[nodiscard]] Result<std::string> use(gui::Purpose purpose, const std::filesystem::path& file,
                                        Instant now);
  [[nodiscard]] Result<void> open(const std::filesystem::path& file, Instant now);
  void open_recent(const std::filesystem::path& file, Instant now);
  [[nodiscard]] Result<std::string> look_for_faces(const std::filesystem::path& folder,
                                                   Instant now);
  void save_composition(Instant now);
  [[nodiscard]] Result<std::string> save_composition(const std::filesystem::path& file);
  void save_all(Instant now);
  /// Whether a gallery or a GLB file is being made in the background.
  [[nodiscard]] bool makes_files() const {
    return gallery_.view().running || !export_.view().file.empty();
  }
  [[nodiscard]] Losses losses() const;
  void show_saved_face(Instant now);
  [[nodiscard]] Result<void> show_face(const std::filesystem::path& folder, Instant now);
  [[nodiscard]] Named named() const;
  [[nodiscard]] SettingsSession::Events settings_events();

  Assets& assets_;
  FaceSession faces_;
  const PlayerOptions& options_;
  pipeline::AuMapping mapping_;
  Notices notices_;
  std::vector<float> face_;         ///< the face that is shown, but without idle movements
  std::vector<float> activations_;  ///< as shown
  PlaybackSession playback_;
  EditorSession editor_;
  ComposerSession composer_;
  MirrorSession mirror_;
  StreamLister lister_;
  Shown shown_ = Shown::Playback;
  std::optional<pipeline::IdleFace> idle_;
  std::optional<pipeline::HairSwing> hair_;
  face::HairSway hair_sway_;
  GallerySession gallery_;
  ExportSession export_;
  OnsetSession onsets_;
  SettingsSession settings_;
  FileSession files_;
  Leaving leaving_;
};

}  // namespace aucast::app
