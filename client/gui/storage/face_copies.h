#pragma once

#include <filesystem>
#include <string>

#include "common/result.h"

namespace aucast::gui {

/// The file in which a copy keeps the AUs that it had when it was made.
inline constexpr const char* kOriginalAusFile = "original_aus.toml";

// Edited faces are copies in the user's own data folder (user_face.h), so that the shipped ones
// stay unchanged. A copy is made, renamed and deleted completely or not at all.

/// Where faces are.
struct FaceFolders {
  std::filesystem::path shipped;
  std::filesystem::path own;
};

/// The face from which this one was copied, as its face.toml says: the name of a shipped face, or
/// the folder of any other. If face.toml does not say, returns the name of this face's folder,
/// because a copy that is made by editing a face has the name of that face.
[[nodiscard]] std::string origin_of(const std::filesystem::path& face_folder);

/// The folder of the shipped face from which this one was copied; empty if there is none.
[[nodiscard]] std::filesystem::path shipped_origin(const std::filesystem::path& own_face,
                                                   const std::filesystem::path& shipped_faces);

/// The folder to write to for the face in `face_folder`. For a face of the user's own and for a
/// classic face it is the same folder. For a classic face save_aus() then fails, because such a
/// face has no AUs of its own. For any other face it is the copy faces.own/NAME, which is made now
/// if it does not exist. If a copy of another face or a link to elsewhere has that name, the next
/// free name is taken.
[[nodiscard]] Result<std::filesystem::path> writable_face(const std::filesystem::path& face_folder,
                                                          const FaceFolders& faces);

/// Copies a face to faces.own/NAME and returns that folder. The copy contains what its face.toml
/// uses from other folders. Fails if there is anything of that name.
[[nodiscard]] Result<std::filesystem::path> copy_face(const std::filesystem::path& face_folder,
                                                      const FaceFolders& faces,
                                                      const std::string& name);

/// Renames a face of the user's own, both its folder and in its face.toml, and returns the new
/// folder. If the folder is a link, only the link is renamed. Fails if there is anything of that
/// name.
[[nodiscard]] Result<std::filesystem::path> rename_face(const std::filesystem::path& own_face,
                                                        const std::string& name);

/// Deletes a face of the user's own. If its folder is a link, only the link is deleted.
[[nodiscard]] Result<void> delete_face(const std::filesystem::path& own_face);

}  // namespace aucast::gui
