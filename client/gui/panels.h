#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/gui/gui_commands.h"
#include "client/gui/gui_model.h"
#include "client/gui/thumbnails.h"
#include "client/gui/widgets.h"
#include "protocol/limits.h"

namespace aucast::gui {

// Each panel is a function from the model to commands, inside an open ImGui window. What belongs to
// its widgets alone (half-typed text, a list's selection) is handed in.

/// What is drawn of the curves.
struct CurvesForm {
  std::shared_ptr<const AuCurves> of;
  std::size_t columns = 0;
  std::vector<std::vector<float>> outlines;  ///< one per curve
  int row = 0;                               ///< that is told of by keys
};
/// How strong each AU is over the stream file that plays; nothing for other streams.
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
  std::array<char, 512> token_file{};
  std::optional<std::string> wrong;  ///< with the text of the address
  bool filled = false;               ///< taken over from the model
  RecordForm record;
  bool large_chart = false;
  bool to_aus = false;  ///< the table of AUs is to be scrolled to
  CurvesForm curves;
};

void remote_panel(const Look& look, const GuiModel& model, RemoteForm& form, GuiCommands& commands);

/// What is being typed in the expression panel.
struct ExpressionForm {
  std::array<char, 512> aus{};    ///< to be shown together
  std::string taken;              ///< the AUs of the expression that were put there last
  int chosen = -1;                ///< the expression whose AUs they are
  std::array<char, 64> search{};  ///< among the expressions without a button
};

/// Named expressions, and AUs put together.
void expression_panel(const Look& look, const GuiModel& model, ExpressionForm& form,
                      GuiCommands& commands);

/// What is chosen in the expression editor.
struct EditorForm {
  int save_as = -1;             ///< number for "save as"; -1: the AU being edited
  std::array<char, 64> name{};  ///< for an AU that FACS does not name
  int named = -1;               ///< the AU whose name was put there
  std::string name_taken;       ///< of the model
  bool to_name = false;         ///< the focus goes to the name
  int opened_for = -1;          ///< the AU whose muscles were opened
};

/// The expression editor: one AU and its muscles.
void editor_panel(const Look& look, const GuiModel& model, EditorForm& form, GuiCommands& commands);

/// What belongs to the composer's widgets.
struct ComposerForm {
  bool linked = true;   ///< one slider for both sides
  Thumbnails pictures;  ///< of keyframes, by their AUs as in a packet
  int rows = 0;         ///< of the timeline, and the one chosen, as of the last frame
  int chosen = -1;
};

/// Faces made of AUs, put in a row as a stream.
void composer_panel(const Look& look, const GuiModel& model, ComposerForm& form,
                    GuiCommands& commands);

/// Before anything was opened: a sample, files, and where the rest is.
void welcome(const Look& look, const GuiModel& model, float width, GuiCommands& commands);

/// How high that bar is; 0: nothing plays that it is for. With little room it has a second line.
[[nodiscard]] float transport_height(const Look& look, const GuiModel& model, float width);
/// The bar under the face by which a stream that is there whole is played; `width`: what the side
/// panel leaves free.
void transport_bar(const Look& look, const GuiModel& model, float width, GuiCommands& commands);
/// What the remote player's panel says about stream files.
void file_part(const GuiModel& model, GuiCommands& commands);
/// Pictures, video, gallery and stream files of what is played, and where they go.
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

/// What the remote player's panel says about sound: volume, level, device; nothing where there is
/// no device.
void sound_part(const Look& look, const GuiModel& model, GuiCommands& commands);
/// Over the face: the stream's title above, what is being said below.
void captions(const Look& look, const GuiModel& model, float width);

/// What is said about the connection.
struct NoticeForm {
  std::string shown;   ///< empty: nothing
  std::string closed;  ///< what was read and clicked away
};

/// Over the face: what is wrong with the connection, and for a while what was just done.
void notices(const Look& look, const GuiModel& model, float width, NoticeForm& form,
             GuiCommands& commands);

/// What is being typed in the file dialog.
struct FileForm {
  std::array<char, 1024> folder{};
  std::array<char, 256> name{};
  std::string shown_folder;  ///< of the model that was taken over
  std::string shown_name;
  bool entered = false;         ///< the folder's field, in the frame before
  bool to_first = false;        ///< the focus goes to the first entry
  bool to_name = false;         ///< the focus goes to the name
  bool waits = false;           ///< it has not come there yet
  std::vector<unsigned> typed;  ///< meanwhile
};

/// The file dialog, while the model has one open.
void file_dialog(const Look& look, const GuiModel& model, FileForm& form, GuiCommands& commands);

/// What is being typed on the Camera tab, and the picture there.
struct MirrorForm {
  std::array<char, 512> source{};
  std::string taken;  ///< of the model
  std::string bind = "127.0.0.1";
  int port = protocol::kDefaultPort;
  bool as_mirror = true;
  bool landmarks = true;
  std::uintptr_t texture = 0;  ///< of the picture that is seen; 0: none
  bool filled = false;
};

/// The Camera tab: one's own face, and who else may see it.
void mirror_panel(const Look& look, const GuiModel& model, MirrorForm& form, GuiCommands& commands);

/// The faces to choose from, their pictures by folder.
void face_part(const Look& look, const GuiModel& model, Thumbnails& pictures,
               GuiCommands& commands);

void rendering_panel(const Look& look, const GuiModel& model, Thumbnails& pictures,
                     GuiCommands& commands);

}  // namespace aucast::gui
