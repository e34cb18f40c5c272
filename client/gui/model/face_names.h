#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace aucast::gui {

enum class FaceKind : std::uint8_t {
  Shipped,
  Own,  ///< in the user's own data folder
  Elsewhere,
};

/// A face to choose.
struct FaceEntry {
  std::string name;
  std::string folder;
  FaceKind kind = FaceKind::Shipped;
  std::string target{};  ///< where the folder leads if it is a link; empty: it is no link
  friend bool operator==(const FaceEntry&, const FaceEntry&) = default;
};

struct FacesView {
  std::shared_ptr<const std::vector<FaceEntry>> entries;  ///< by kind, then by name; null: none
  std::string shown;                                      ///< the folder of the face in the window
  std::string elsewhere;  ///< the folder with the faces of FaceKind::Elsewhere; empty: none
  friend bool operator==(const FacesView&, const FacesView&) = default;
};

/// Shows the face in this folder, now and when the window is opened next time.
struct ShowFace {
  std::string folder;
};
/// Copies the face in this folder to a new one of the user's own, and shows the copy.
struct CopyFace {
  std::string folder;
  std::string name;
};
/// Renames a face of the user's own.
struct RenameFace {
  std::string folder;
  std::string name;
};
/// Deletes a face of the user's own. If it is shown, the shipped face from which it was copied is
/// shown instead.
struct DeleteFace {
  std::string folder;
};
/// About the faces to choose from.
using FaceCommand = std::variant<ShowFace, CopyFace, RenameFace, DeleteFace>;

/// The entry of the face in this folder; null: it is not listed.
[[nodiscard]] const FaceEntry* listed_face(const FacesView& faces, const std::string& folder);
/// The entry of the face in the window; null: it is not listed.
[[nodiscard]] inline const FaceEntry* shown_face(const FacesView& faces) {
  return listed_face(faces, faces.shown);
}

/// What is wrong with a name for a face of the user's own, as a sentence; empty: nothing. The name
/// of a shipped face is reserved for the copy that is made when that face is edited.
[[nodiscard]] std::string wrong_face_name(const std::string& name, const FacesView& faces);

/// Whether a shipped face or one of the user's own has this name.
[[nodiscard]] bool is_face_name(const std::string& name, const FacesView& faces);

/// The name without a number at its end: "anna" for "anna 2".
[[nodiscard]] std::string without_number(const std::string& name);

/// A name for a copy of the face `of`: "anna 2", with the first number that is not taken. `taken`:
/// tells whether a name is taken.
template <typename Taken>
[[nodiscard]] std::string name_for_copy(const std::string& of, const Taken& taken) {
  const std::string begin = without_number(of) + " ";
  int number = 2;
  while (taken(begin + std::to_string(number))) ++number;
  return begin + std::to_string(number);
}

}  // namespace aucast::gui
