#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "client/gui/storage/aus_file.h"
#include "common/result.h"

namespace aucast::gui {

// The folder of the user's own faces (face_copies.h makes them), and what is saved in one.

/// The path $XDG_DATA_HOME/aucast/faces, else ~/.local/share/aucast/faces. The arguments are the
/// values of XDG_DATA_HOME and HOME, null if unset. A relative XDG_DATA_HOME counts as unset, as
/// its specification demands. Fails if both are unset.
[[nodiscard]] Result<std::filesystem::path> user_faces_folder(const char* xdg_data_home,
                                                              const char* home);

/// Whether this folder is a face, in our format or the classic one.
[[nodiscard]] bool is_face(const std::filesystem::path& folder);

/// The faces in a folder of faces, sorted by name, in our format or the classic one. The caller
/// sets their kind. Empty if there is no such folder.
[[nodiscard]] std::vector<FaceEntry> faces_in(const std::filesystem::path& folder);

/// Whether a face lies in the folder of the user's own faces.
[[nodiscard]] bool is_own_face(const std::filesystem::path& face_folder,
                               const std::filesystem::path& user_faces);

/// An AU for save_aus().
struct SavedAu {
  int number = 0;
  Drive drive;
  std::string name;  ///< its note; empty: the note stays
};
/// Saves AUs in the AU file of a face of our own format and returns that file. The previous version
/// is kept beside it with a ~ at the end of its name. If this fails, nothing has changed.
[[nodiscard]] Result<std::filesystem::path> save_aus(const std::filesystem::path& face_folder,
                                                     const std::vector<SavedAu>& aus);
/// Removes one AU from the AU file in the same way, and returns the file.
[[nodiscard]] Result<std::filesystem::path> remove_au(const std::filesystem::path& face_folder,
                                                      int number);

}  // namespace aucast::gui
