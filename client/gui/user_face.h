#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/aus_file.h"
#include "client/gui/gui_model.h"
#include "common/result.h"

namespace aucast::gui {

// Where edited faces live: copies in the user's own data folder, so that the shipped ones stay as
// they are.

/// $XDG_DATA_HOME/aucast/faces, or ~/.local/share/aucast/faces; the arguments are the values of
/// XDG_DATA_HOME and HOME, null when unset. A relative XDG_DATA_HOME counts as unset, as its
/// specification wants. Failed when there is neither.
[[nodiscard]] Result<std::filesystem::path> user_faces_folder(const char* xdg_data_home,
                                                              const char* home);

/// The folder to write to for the face in `face_folder`: itself when it lies in `user_faces`, else
/// user_faces/NAME, copied now unless it is there. A copy appears whole or not at all, and has in
/// it what its face.toml takes from other folders.
[[nodiscard]] Result<std::filesystem::path> writable_face(const std::filesystem::path& face_folder,
                                                          const std::filesystem::path& user_faces);

/// Whether this folder is a face, in our format or the classic one.
[[nodiscard]] bool is_face(const std::filesystem::path& folder);

/// The faces in a folder of faces, by name, in our format or the classic one; the kind is left to
/// the caller. None when there is no such folder.
[[nodiscard]] std::vector<FaceEntry> faces_in(const std::filesystem::path& folder);

/// Whether a face lies in the folder of the user's own ones.
[[nodiscard]] bool is_own_face(const std::filesystem::path& face_folder,
                               const std::filesystem::path& user_faces);

/// An AU to be saved.
struct SavedAu {
  int number = 0;
  Drive drive;
  std::string name;  ///< its note; empty: as it is
};
/// Saves AUs in the AU file of a face of our own format and returns that file. The version before
/// stays beside it with a ~ at its end. What was there is untouched when this fails.
[[nodiscard]] Result<std::filesystem::path> save_aus(const std::filesystem::path& face_folder,
                                                     const std::vector<SavedAu>& aus);
/// Takes one AU out of that file, in the same way.
[[nodiscard]] Result<std::filesystem::path> remove_au(const std::filesystem::path& face_folder,
                                                      int number);

}  // namespace aucast::gui
