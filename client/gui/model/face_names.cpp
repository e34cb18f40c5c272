#include "client/gui/model/face_names.h"

#include <algorithm>

#include "client/gui/texts/texts.h"
#include "common/text.h"

namespace aucast::gui {

const FaceEntry* listed_face(const FacesView& faces, const std::string& folder) {
  if (faces.entries == nullptr) return nullptr;
  const auto found = std::find_if(faces.entries->begin(), faces.entries->end(),
                                  [&](const FaceEntry& face) { return face.folder == folder; });
  return found == faces.entries->end() ? nullptr : &*found;
}

std::string wrong_face_name(const std::string& name, const FacesView& faces) {
  if (name.find_first_not_of(' ') == std::string::npos) return tr("file.unnamed");
  if (printable(name) != name) return tr("face.wrong_letters");
  if (name.find('/') != std::string::npos) return tr("face.wrong_sign", "/");
  if (name.front() == '.') return tr("face.hidden");
  if (faces.entries == nullptr) return {};
  for (const FaceEntry& face : *faces.entries) {
    if (face.name != name) continue;
    if (face.kind == FaceKind::Shipped) return tr("face.is_shipped", name);
    if (face.kind == FaceKind::Own) return tr("face.there", name);
  }
  return {};
}

bool is_face_name(const std::string& name, const FacesView& faces) {
  return faces.entries != nullptr &&
         std::any_of(faces.entries->begin(), faces.entries->end(), [&](const FaceEntry& face) {
           return face.kind != FaceKind::Elsewhere && face.name == name;
         });
}

std::string without_number(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  const bool numbered =
      end != std::string::npos && end > 0 && end + 1 < name.size() && name[end] == ' ';
  return numbered ? name.substr(0, end) : name;
}

}  // namespace aucast::gui
