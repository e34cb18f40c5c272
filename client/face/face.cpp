#include "client/face/face.h"

#include <algorithm>
#include <system_error>

#include "client/face/classic_folder.h"
#include "client/face/face_folder.h"

namespace aucast::face {

Side side_at(float x) {
  constexpr float kCentral = 0.05F;
  if (x >= kCentral) return Side::Left;
  return x <= -kCentral ? Side::Right : Side::Both;
}

std::optional<std::size_t> Face::channel_index(std::string_view channel_name) const {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == channel_name) return i;
  }
  return std::nullopt;
}

Result<Face> load_face(const std::filesystem::path& folder,
                       const std::filesystem::path& data_folder) {
  std::error_code error;
  const bool classic = !std::filesystem::exists(folder / kFaceFile, error) &&
                       std::filesystem::exists(folder / "faceline.dat", error);
  return classic ? load_classic_folder(folder, data_folder) : load_face_folder(folder);
}

}  // namespace aucast::face
