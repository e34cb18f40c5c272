#pragma once

#include <string>

#include "client/gui/model/gui_model.h"

namespace aucast::gui {

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
