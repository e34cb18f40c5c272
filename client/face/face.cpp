#include "client/face/face.h"

#include <algorithm>
#include <system_error>

#include "client/face/face_folder.h"

namespace aucast::face {

std::optional<std::size_t> Face::channel_index(std::string_view channel_name) const {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == channel_name) return i;
  }
  return std::nullopt;
}

Result<Face> load_face(const std::filesystem::path& folder,
                       const std::filesystem::path& data_folder) {
  static_cast<void>(data_folder);
  return load_face_folder(folder);
}

}  // namespace aucast::face
