#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/model/gui_commands.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/model/steady_rows.h"
#include "client/gui/model/thumbnails.h"
#include "client/gui/widgets/widgets.h"
#include "protocol/limits.h"

namespace aucast::gui {

// Each panel is a function from the model to commands, called inside an open ImGui window. The
// state of its widgets (half-typed text, a list's selection) is handed in as its form. Members
// described as "of the model" remember what the form last took from the model.

/// The curves as they are drawn.
struct CurvesForm {
  /// Of the model. When other curves come, the part opens if they are few, and folds if many.
  std::shared_ptr<const AuCurves> shown;
  std::shared_ptr<const AuCurves> of;        ///< the curves that `outlines` was made from
  std::size_t columns = 0;                   ///< the number of columns that `outlines` has
  std::vector<std::vector<float>> outlines;  ///< one per curve
  int row = 0;                               ///< the curve chosen by keys, whose value is shown
};
/// Shows how strong each AU is over the stream file that plays. Draws nothing for other streams.
void curves_part(const Look& look, const GuiModel& model, CurvesForm& form, GuiCommands& commands);

/// What is being typed about pictures and videos.
struct RecordForm {
  std::array<char, 512> folder{};
  std::array<char, 128> name{};
  PictureSettings taken;  ///< of the model
  bool filled = false;
};

/// What is being typed into the remote player's form.
struct RemoteForm {
  RemoteSettings settings;
  std::array<char, 512> address{};
  std::array<char, 4096> authorities_file{};  // as long as a path may be
  std::array<char, 4096> token_file{};
  CredentialFiles chosen;            ///< the files that were put into the two fields above last
  std::optional<std::string> wrong;  ///< what is wrong with the text of the address; nullopt:
                                     ///< nothing
  bool filled = false;               ///< the form has been filled from the model
  bool renamed = false;              ///< the address has been changed in this frame
  RecordForm record;
  bool large_chart = false;   ///< the chart of the strongest AUs is large
  bool large_buffer = false;  ///< the chart of the receiver's fill is large
  SteadyRows aus;
  bool to_aus = false;  ///< scroll to the table of AUs
  CurvesForm curves;
};

/// The Play tab: where streams come from, what is received, sound, pictures and curves.
void remote_panel(const Look& look, const GuiModel& model, RemoteForm& form, GuiCommands& commands);

/// What is being typed in the expression panel.
struct ExpressionForm {
  std::array<char, 512> aus{};    ///< AUs to be shown together
  std::string taken;              ///< the expression's AUs that were put into `aus` last
  int chosen = -1;                ///< the expression that has the AUs in `taken`
  std::array<char, 64> search{};  ///< the text to look for among the expressions without a button
};

/// Named expressions, and combined AUs.
void expression_panel(const Look& look, const GuiModel& model, ExpressionForm& form,
                      GuiCommands& commands);

/// What is chosen in the expression editor.
struct EditorForm {
  int save_as = -1;             ///< the AU to save as; -1: the AU being edited
  std::array<char, 64> name{};  ///< for an AU that FACS does not name
  int named = -1;               ///< the AU whose name is in `name`
  std::string name_taken;       ///< of the model
  bool to_name = false;         ///< give the focus to the name
  int opened_for = -1;          ///< the AU whose groups of muscles were opened
  bool comes = false;           ///< the editor's tab was chosen in this frame
};

/// The expression editor: one AU and its muscles.
void editor_panel(const Look& look, const GuiModel& model, EditorForm& form, GuiCommands& commands);

/// What belongs to the composer's widgets.
struct ComposerForm {
  bool linked = true;   ///< one slider for both sides
  Thumbnails pictures;  ///< of keyframes, by their AUs as in a packet
  int rows = 0;         ///< number of rows in the timeline in the last frame
  int chosen = -1;      ///< the keyframe chosen in the last frame; -1: none
};

/// The composer: makes a stream from faces that are made of AUs.
void composer_panel(const Look& look, const GuiModel& model, ComposerForm& form,
                    GuiCommands& commands);

/// What is shown until something is opened: a sample, files, and where to find the rest.
void welcome(const Look& look, const GuiModel& model, float width, GuiCommands& commands);

/// The height of transport_bar(); 0 if it is not shown: nothing plays, or a stream that is not
/// available whole. If `width` is small, it has a second line.
[[nodiscard]] float transport_height(const Look& look, const GuiModel& model, float width);
/// The bar under the face, to control a stream that is available whole. `width`: what the side
/// panel leaves free.
void transport_bar(const Look& look, const GuiModel& model, float width, GuiCommands& commands);
/// The part for saving what is shown and played: pictures, video, gallery and stream files, and
/// where they go.
void record_part(const Look& look, const GuiModel& model, RecordForm& form, GuiCommands& commands);

/// What is being typed in the gallery's dialog.
struct GalleryForm {
  std::array<char, 512> folder{};
  std::array<char, 256> sweeps{};
  std::string folder_taken;  ///< of the model
  std::string sweeps_taken;
};
/// The gallery's dialog, while the model has it open.
void gallery_dialog(const Look& look, const GuiModel& model, float width, GalleryForm& form,
                    GuiCommands& commands);

/// The part of the remote player's panel about sound: volume, level, device. Draws nothing if there
/// is no device.
void sound_part(const Look& look, const GuiModel& model, GuiCommands& commands);
/// Draws the stream's title over the top of the face, and the caption over its bottom. `taken`: the
/// height that the transport bar and notices() take at the bottom.
void captions(const Look& look, const GuiModel& model, float width, float taken);

/// The notice about the connection.
struct NoticeForm {
  std::string shown;          ///< empty: none
  std::string closed;         ///< the one that the user has closed
  bool other_server = false;  ///< the address has been changed since the last frame
};

/// Shows over the face what is wrong with the connection and, for a while, what was just done.
/// `bar`: the height that the transport bar takes at the bottom. Returns the height that bar and
/// notices take there together.
float notices(const Look& look, const GuiModel& model, float width, float bar, NoticeForm& form,
              GuiCommands& commands);

/// What is being typed in the file dialog.
struct FileForm {
  std::array<char, 1024> folder{};
  std::array<char, 256> name{};
  std::string shown_folder;  ///< the folder that was taken from the model
  std::string shown_name;
  std::string tried;            ///< the choice that was refused; empty: none was
  bool entered = false;         ///< the field of the folder was active in the previous frame
  bool named = false;           ///< a new file was named in the previous frame
  bool to_first = false;        ///< give the focus to the first entry
  bool to_name = false;         ///< give the focus to the name
  bool waits = false;           ///< the focus has not arrived at the entry or the name yet
  std::vector<unsigned> typed;  ///< characters typed until the focus arrives
};

/// The file dialog, while the model has one open.
void file_dialog(const Look& look, const GuiModel& model, FileForm& form, GuiCommands& commands);

/// What is being typed on the Camera tab, and its picture.
struct MirrorForm {
  std::array<char, 512> source{};
  std::string taken;  ///< of the model
  std::string bind = "127.0.0.1";
  int port = protocol::kDefaultPort;
  bool as_mirror = true;
  bool landmarks = true;
  std::uintptr_t texture = 0;  ///< ImGui's texture ID of the picture; 0: none
  bool filled = false;
};

/// The Camera tab: the user's own face, and who else may see it.
void mirror_panel(const Look& look, const GuiModel& model, MirrorForm& form, GuiCommands& commands);

/// What belongs to the faces to choose from.
struct FaceForm {
  enum class Asks : std::uint8_t { Nothing, Copy, Rename, Delete };

  Thumbnails pictures;          ///< by the faces' folders
  Asks asks = Asks::Nothing;    ///< what face_dialog() asks
  std::string folder;           ///< of the face that the question is about
  std::array<char, 64> name{};  ///< the name typed in the dialog
};
/// The faces to choose from, and what can be done with the user's own.
void face_part(const Look& look, const GuiModel& model, FaceForm& form, GuiCommands& commands);
/// Asks for a face's name, or whether to delete a face, as `form.asks` says.
void face_dialog(const Look& look, const GuiModel& model, FaceForm& form, GuiCommands& commands);

/// Asks whether to leave although something would be lost.
void leave_dialog(const Look& look, const GuiModel& model, GuiCommands& commands);

/// The View tab: which face is shown, which parts of it are drawn, and how the window looks.
void rendering_panel(const Look& look, const GuiModel& model, FaceForm& form,
                     GuiCommands& commands);

}  // namespace aucast::gui
