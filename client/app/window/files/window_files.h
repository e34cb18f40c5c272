#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "client/app/assets.h"
#include "client/app/notices.h"
#include "client/app/player_options.h"
#include "client/app/window/files/export_session.h"
#include "client/app/window/files/file_names.h"
#include "client/app/window/files/file_session.h"
#include "client/app/window/files/gallery_session.h"
#include "client/app/window/files/shown.h"
#include "client/app/window/making/composer_session.h"
#include "client/app/window/making/editor_session.h"
#include "client/app/window/making/face_session.h"
#include "client/app/window/playing/mirror_session.h"
#include "client/app/window/playing/playback_session.h"
#include "client/app/window/recording/onset_session.h"
#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/storage/kept_settings.h"

namespace aucast::app {

/// Files in the window: uses the file that was chosen in the dialog, opens streams, and remembers
/// how tables are read. The constructor's arguments must outlive it. Thread: the player's.
class WindowFiles {
 public:
  /// The sessions that use the files.
  struct Users {
    PlaybackSession& playback;
    EditorSession& editor;
    ComposerSession& composer;
    FaceSession& faces;
    GallerySession& gallery;
    ExportSession& exports;
    OnsetSession& onsets;
    MirrorSession& mirror;
    Notices& notices;
  };
  struct Hooks {
    /// Shows the face in this folder in place of the present one.
    std::function<Result<void>(const std::filesystem::path& folder, Instant now)> show_face;
    /// Shows the face of this session. For the editor and the composer, also pauses what plays.
    std::function<void(Shown shown, Instant now)> show;
    /// Call it when AUs were saved: shows the face that has them.
    std::function<void(Instant now)> show_saved_face;
    /// Sets the folder for pictures.
    std::function<void(const std::filesystem::path& folder)> put_pictures_in;
    /// These three return what the window shows: in words for file names, as options of the command
    /// line, and as activations.
    std::function<Named()> named;
    std::function<PlayerOptions()> options_as_shown;
    std::function<const std::vector<float>&()> activations;
  };
  /// `played`: the file that the command line asks to play; empty: none.
  WindowFiles(const Assets& assets, const std::filesystem::path& played, const Users& users,
              Hooks hooks);

  /// Begins with what the window remembered.
  void begin_with(const gui::KeptSettings& kept);
  /// Adds what the window should remember.
  void keep(gui::KeptSettings& kept) const;

  void apply(const gui::FileCommand& command, Instant now);
  /// Saves the composed stream in the file that it came from, or asks the user for a file.
  void save_composition(Instant now);

  /// The name of what plays, without a file's ending; empty: it has none. `shows`: whether the
  /// window shows the face of what plays; if not, a server's stream counts as nameless.
  [[nodiscard]] std::string name_of_stream(bool shows) const;
  /// Streams that were opened, the newest first.
  [[nodiscard]] const std::vector<std::string>& recent() const { return files_.recent(); }
  [[nodiscard]] const gui::BrowserView& browser() const { return files_.view(); }
  [[nodiscard]] const gui::CredentialFiles& credentials() const { return credentials_; }
  [[nodiscard]] const gui::TablesView& tables() const { return tables_; }
  /// A stream file that came with the player; empty: none did.
  [[nodiscard]] const std::string& sample() const { return sample_; }

 private:
  void browse(gui::Purpose purpose);
  void open_recent(const std::filesystem::path& file, Instant now);
  [[nodiscard]] Result<void> open(const std::filesystem::path& file, Instant now);
  [[nodiscard]] Result<void> play(const std::filesystem::path& file, Instant now);
  [[nodiscard]] Result<void> play_sound(const std::filesystem::path& file, Instant now);
  [[nodiscard]] Result<std::string> save_composition(const std::filesystem::path& file);
  [[nodiscard]] Result<std::string> look_for_faces(const std::filesystem::path& folder,
                                                   Instant now);
  [[nodiscard]] Result<std::string> import_aus(const std::filesystem::path& file, Instant now);
  [[nodiscard]] Result<std::string> use(gui::Purpose purpose, const std::filesystem::path& file,
                                        Instant now);

  const Assets& assets_;
  std::filesystem::path played_;
  Users users_;
  Hooks hooks_;
  FileSession files_;
  gui::CredentialFiles credentials_;
  gui::TablesView tables_;
  std::string sample_;
};

}  // namespace aucast::app
